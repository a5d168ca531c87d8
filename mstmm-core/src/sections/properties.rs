//! What a section is to a beam, and which sizes it may have.

use crate::model::error::{InvalidParameter, Requirement};
use crate::sections::number::Number;

/// Area and moments of a section, about its axes y and z.
///
/// Times the modulus of elasticity, the shear modulus or the density they are parameters of beams:
///
/// | | |
/// |---|---|
/// | `axial_stiffness` | `E area` |
/// | `bending_stiffness_y`, `bending_stiffness_z` | `E i_y`, `E i_z` |
/// | `torsional_stiffness` | `G torsion` |
/// | `mass_per_length` | `ρ area` |
/// | `rotary_inertia_y`, `rotary_inertia_z` | `ρ i_y`, `ρ i_z` |
/// | `polar_inertia_per_length` | `ρ polar()` |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Properties<T> {
    /// The area \[m²\].
    pub area: T,
    /// The second moment of area about y, `∫ z² dA` \[m⁴\].
    pub i_y: T,
    /// The second moment of area about z, `∫ y² dA` \[m⁴\].
    pub i_z: T,
    /// The torsion constant J of Saint-Venant \[m⁴\]: torque = G J times the twist per length.
    pub torsion: T,
}

impl<T: Number> Properties<T> {
    /// The polar second moment of area, `i_y + i_z` \[m⁴\]: that of inertia, which is the torsion constant of round sections alone.
    ///
    /// ```
    /// use mstmm_core::sections::Rectangle;
    ///
    /// let plank = Rectangle { width: 0.2, height: 0.03 }.properties()?;
    /// assert!(plank.polar() > 10.0 * plank.torsion);
    /// # Ok::<(), mstmm_core::InvalidParameter>(())
    /// ```
    #[must_use]
    pub fn polar(&self) -> T {
        self.i_y + self.i_z
    }

    /// As a tuple, for formulas.
    pub(super) fn tuple(self) -> (T, T, T, T) {
        (self.area, self.i_y, self.i_z, self.torsion)
    }
}

/// The parts of the area that carry shear, in a beam of Timoshenko: `shear_stiffness = coefficient G area`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShearCoefficients<T> {
    /// For deflections along y.
    pub y: T,
    /// For deflections along z.
    pub z: T,
}

impl<T> ShearCoefficients<T> {
    /// As a tuple, for formulas.
    pub(super) fn tuple(self) -> (T, T) {
        (self.y, self.z)
    }
}

/// Sizes whose fourth powers are far from the ends of the range of numbers.
const SIZES: Requirement = Requirement::Between { least: 1e-50, most: 1e50 };

/// Checks that a size is positive, and neither tiny nor huge.
pub(super) fn check_size<T: Number>(name: &'static str, size: T) -> Result<(), InvalidParameter> {
    check_ends(Requirement::Positive, name, size)?;
    check_ends(SIZES, name, size)
}

/// Checks that a size is greater than what it has inside.
pub(super) fn check_room<T: Number>(
    name: &'static str,
    size: T,
    inside: T,
    formula: &'static str,
) -> Result<(), InvalidParameter> {
    let [_, most] = inside.ends();
    check_ends(Requirement::above(most, formula), name, size)
}

/// Checks both ends of a number.
pub(super) fn check_ends<T: Number>(
    requirement: Requirement,
    name: &'static str,
    number: T,
) -> Result<(), InvalidParameter> {
    number.ends().into_iter().try_for_each(|end| requirement.check(name, end))
}

/// Checks a Poisson ratio.
pub(super) fn check_ratio<T: Number>(poisson_ratio: T) -> Result<(), InvalidParameter> {
    check_ends(Requirement::Between { least: 0.0, most: 0.5 }, "poisson_ratio", poisson_ratio)
}

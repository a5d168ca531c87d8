//! Round sections, full and hollow.

use crate::model::error::{InvalidParameter, Requirement};
use crate::sections::number::Number;
use crate::sections::properties::{Properties, ShearCoefficients, check_ends, check_ratio, check_room, check_size};
use core::f64::consts::PI;

/// A full circle.
///
/// ```
/// use mstmm_core::sections::Round;
///
/// let rod = Round { diameter: 0.02 }.properties()?;
/// assert!((rod.area - 3.1416e-4).abs() < 1e-8);
/// assert_eq!(rod.torsion, rod.polar());
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round<T> {
    /// The diameter d \[m\].
    pub diameter: T,
}

impl<T: Number> Round<T> {
    /// `A = π d²/4`, `I = π d⁴/64`, `J = 2 I`.
    ///
    /// # Errors
    /// [`InvalidParameter`] for a diameter that is not positive, or not from 1e-50 to 1e50.
    pub fn properties(self) -> Result<Properties<T>, InvalidParameter> {
        check_size("diameter", self.diameter)?;
        Ok(ring(self.diameter, T::constant(0.0)))
    }

    /// `k = 6 (1 + ν)/(7 + 6 ν)` in both directions, given the Poisson ratio ν.
    ///
    /// # Errors
    /// [`InvalidParameter`] as of [`properties`](Round::properties), and for a ratio that is not from 0 to 0.5.
    ///
    /// # Source
    /// G. R. Cowper, The shear coefficient in Timoshenko's beam theory, Journal of Applied Mechanics 33, 1966.
    pub fn shear_coefficients(self, poisson_ratio: T) -> Result<ShearCoefficients<T>, InvalidParameter> {
        check_size("diameter", self.diameter)?;
        check_ratio(poisson_ratio)?;
        Ok(ring_shear(T::constant(0.0), poisson_ratio))
    }
}

/// A circle with a round hole at its centre, of any thickness.
///
/// ```
/// use mstmm_core::sections::Tube;
///
/// let (outer, inner) = (0.2, 0.18);
/// let leg = Tube { outer, inner }.properties()?;
/// assert!((leg.area / 5.969e-3 - 1.0).abs() < 1e-4);
/// assert!((leg.i_y / 2.701e-5 - 1.0).abs() < 1e-4);
///
/// let error = Tube { outer: inner, inner: outer }.properties().unwrap_err();
/// assert_eq!(error.to_string(), "outer is 0.18, but must be finite and greater than inner = 0.2");
/// # Ok::<(), mstmm_core::InvalidParameter>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube<T> {
    /// The outer diameter D \[m\].
    pub outer: T,
    /// The inner diameter d \[m\]; zero for a full circle.
    pub inner: T,
}

impl<T: Number> Tube<T> {
    /// `A = π (D² - d²)/4`, `I = π (D⁴ - d⁴)/64`, `J = 2 I`.
    ///
    /// # Errors
    /// [`InvalidParameter`] for an outer diameter that is not positive, or not from 1e-50 to 1e50, and for an inner one that is negative, or not
    /// less than the outer one.
    pub fn properties(self) -> Result<Properties<T>, InvalidParameter> {
        self.check()?;
        Ok(ring(self.outer, self.inner))
    }

    /// `k = 6 (1 + ν) (1 + m²)²/((7 + 6 ν) (1 + m²)² + (20 + 12 ν) m²)` in both directions, with `m = d/D`, given the Poisson ratio ν.
    ///
    /// # Errors
    /// [`InvalidParameter`] as of [`properties`](Tube::properties), and for a ratio that is not from 0 to 0.5.
    ///
    /// # Source
    /// G. R. Cowper, The shear coefficient in Timoshenko's beam theory, Journal of Applied Mechanics 33, 1966.
    pub fn shear_coefficients(self, poisson_ratio: T) -> Result<ShearCoefficients<T>, InvalidParameter> {
        self.check()?;
        check_ratio(poisson_ratio)?;
        Ok(ring_shear(self.inner / self.outer, poisson_ratio))
    }

    fn check(self) -> Result<(), InvalidParameter> {
        check_size("outer", self.outer)?;
        check_ends(Requirement::NonNegative, "inner", self.inner)?;
        check_room("outer", self.outer, self.inner, "inner")
    }
}

/// The properties of a ring, without cancellation where it is thin.
fn ring<T: Number>(outer: T, inner: T) -> Properties<T> {
    let difference = (outer - inner) * (outer + inner);
    let i = difference * (outer * outer + inner * inner) * (PI / 64.0);
    Properties { area: difference * (PI / 4.0), i_y: i, i_z: i, torsion: i * 2.0 }
}

/// The shear coefficients of a ring, given the ratio of its diameters.
fn ring_shear<T: Number>(ratio: T, nu: T) -> ShearCoefficients<T> {
    let square = ratio * ratio;
    let sum = (square + 1.0) * (square + 1.0);
    let k = (nu + 1.0) * 6.0 * sum / ((nu * 6.0 + 7.0) * sum + (nu * 12.0 + 20.0) * square);
    ShearCoefficients { y: k, z: k }
}

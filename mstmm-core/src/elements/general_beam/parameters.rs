//! The parameters of a general beam as its equations have them: with the shear flexibility in the place of the shear stiffness.

use crate::model::{InvalidParameter, Requirement};
use crate::number::{Parameter, Truth};

/// The parameters of a beam, or the derivatives with respect to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BeamParameters<T> {
    /// Length l \[m\].
    pub(crate) length: T,
    /// Bending stiffness EI [N m²].
    pub(crate) bending_stiffness: T,
    /// Mass per length m [kg/m].
    pub(crate) mass_per_length: T,
    /// Shear flexibility `f = 1/(k G A)` [1/N]; zero is a beam without shear.
    pub(crate) shear_flexibility: T,
    /// Rotary inertia per length `r = ρ I` [kg m].
    pub(crate) rotary_inertia: T,
    /// Axial force N \[N\], positive in tension.
    pub(crate) axial_force: T,
    /// Stiffness k of the foundation per length [N/m²].
    pub(crate) foundation_stiffness: T,
    /// Stiffness G of the shear layer of the foundation \[N\].
    pub(crate) foundation_shear_stiffness: T,
}

impl<T: Parameter> BeamParameters<T> {
    /// What holds against the slope, `N + G`.
    pub(crate) fn tension(&self) -> T {
        self.axial_force + self.foundation_shear_stiffness
    }

    /// Whether it has neither shear nor rotary inertia nor an axial force.
    pub(super) fn bends_only(&self) -> bool {
        let others = [self.shear_flexibility, self.rotary_inertia, self.axial_force, self.foundation_shear_stiffness];
        others.iter().all(|parameter| parameter.vanishes().all())
    }

    /// Checks each parameter against its range, given the shear stiffness; zero where the beam is rigid in shear.
    pub(super) fn check(&self, shear_stiffness: T) -> Result<(), InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("bending_stiffness", self.bending_stiffness)?;
        Requirement::NonNegative.check("mass_per_length", self.mass_per_length)?;
        Requirement::NonNegative.check("rotary_inertia", self.rotary_inertia)?;
        Requirement::NonNegative.check("foundation_stiffness", self.foundation_stiffness)?;
        Requirement::NonNegative.check("foundation_shear_stiffness", self.foundation_shear_stiffness)?;
        if shear_stiffness.vanishes().all() {
            return Requirement::Finite.check("axial_force", self.axial_force);
        }
        let bound = T::zero() - shear_stiffness - self.foundation_shear_stiffness;
        let formula = "-shear_stiffness - foundation_shear_stiffness";
        Requirement::above(bound, formula).check("axial_force", self.axial_force)
    }
}

impl<S> BeamParameters<S> {
    /// The parameters as numbers of another type.
    #[inline]
    pub(crate) fn map<R>(self, to: impl Fn(S) -> R) -> BeamParameters<R> {
        BeamParameters {
            length: to(self.length),
            bending_stiffness: to(self.bending_stiffness),
            mass_per_length: to(self.mass_per_length),
            shear_flexibility: to(self.shear_flexibility),
            rotary_inertia: to(self.rotary_inertia),
            axial_force: to(self.axial_force),
            foundation_stiffness: to(self.foundation_stiffness),
            foundation_shear_stiffness: to(self.foundation_shear_stiffness),
        }
    }
}

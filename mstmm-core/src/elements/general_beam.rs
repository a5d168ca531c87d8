//! The general uniform beam: shear, rotary inertia, axial force, elastic foundation.

use crate::element::BeamNumbers;
use crate::elements::shared::compound::Units;
use crate::model::{Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Parameter, Scalar, Single, Truth};
use compound::GeneralCompound;
use constants::{Constants, SectionAt};
use nalgebra::Matrix4;
use parameters::BeamParameters;
use transfer::{BackThrough, Transfer};

mod chart;
mod compound;
mod constants;
mod damped;
mod damped_beam;
mod damped_spinning;
mod damped_spinning_beam;
mod held;
mod inside;
mod kinds;
mod members;
mod motion;
mod of_built;
mod parameters;
mod spinning;
mod spinning_beam;
mod transfer;
mod under_load;
mod wave_pair;

pub use damped_beam::DampedBeam;
pub use damped_spinning_beam::DampedSpinningBeam;
pub use kinds::{BeamColumn, FoundationBeam, GeneralBeam, RayleighBeam, TimoshenkoBeam};
pub use spinning_beam::SpinningBeam;

/// A beam with its quantities that do not depend on the frequency.
#[derive(Clone, Copy, Debug)]
pub struct BuiltGeneralBeam<T> {
    parameters: BeamParameters<T>,
    /// The shear stiffness, of which the shear flexibility is the rounded inverse; zero where the beam is rigid in shear.
    shear_stiffness: T,
    constants: Constants<T>,
    units: Units<T>,
}

impl<T: Parameter> BuiltGeneralBeam<T> {
    /// A beam whose shear flexibility is that of a shear stiffness; zero where it is rigid in shear.
    ///
    /// # Errors
    /// The error names the parameter that is out of its range, with its value.
    fn new(parameters: BeamParameters<T>, shear_stiffness: T) -> Result<Self, InvalidParameter> {
        parameters.check(shear_stiffness)?;
        let BeamParameters { length, bending_stiffness, .. } = parameters;
        let built = BuiltGeneralBeam {
            parameters,
            shear_stiffness,
            constants: Constants::of(parameters),
            units: Units::new(bending_stiffness, T::one() / length),
        };
        if let Some((parameter, value)) = built.constants.out_of_range(&parameters, shear_stiffness) {
            return Err(InvalidParameter { parameter, value, requirement: Requirement::Rescale });
        }
        if !built.units.are_in_range() {
            let powers = [("bending_stiffness", bending_stiffness), ("length", length)];
            return Err(InvalidParameter::most_extreme(powers));
        }
        Ok(built)
    }

    /// Adds an axial force.
    fn add_axial_force(&mut self, force: [f64; 2]) -> Result<(), InvalidParameter> {
        let axial_force = self.parameters.axial_force + T::of_words(force);
        *self = BuiltGeneralBeam::new(BeamParameters { axial_force, ..self.parameters }, self.shear_stiffness)?;
        Ok(())
    }

    fn estimate(&self, estimates: &mut FrequencyEstimates) {
        let BeamParameters { length, bending_stiffness, mass_per_length, rotary_inertia, .. } = self.parameters;
        let [l, ei, m, r] = [length, bending_stiffness, mass_per_length, rotary_inertia].map(T::to_f64);
        let foundation = self.parameters.foundation_stiffness.to_f64();
        // where bending has z = 1
        estimates.waves((T::one() / self.constants.mass).sqrt().to_f64());
        estimates.translational_stiffness(ei / (l * l * l));
        estimates.translational_stiffness(foundation * l);
        estimates.translational_stiffness(self.parameters.tension().to_f64().abs() / l);
        estimates.torsional_stiffness(ei / l);
        estimates.length(l);
        estimates.mass(m * l);
        estimates.moment_of_inertia(m * l * l * l);
        estimates.moment_of_inertia(r * l);
    }

    /// The mass per length.
    fn mass_per_length(&self) -> T {
        self.parameters.mass_per_length
    }

    fn extent(&self) -> Extent {
        let BeamParameters { length, bending_stiffness, .. } = self.parameters;
        Extent::along(length.to_f64()).of_stiffness(bending_stiffness.to_f64())
    }

    /// The extent of a shaft: a solid one has `ρI = ρA r²/4`.
    fn extent_of_shaft(&self) -> Extent {
        let BeamParameters { mass_per_length, rotary_inertia, .. } = self.parameters;
        let square = (rotary_inertia / mass_per_length).to_f64();
        // a shaft without mass tells no radius
        self.extent().of_radius(if square.is_finite() { 2.0 * Scalar::sqrt(square) } else { 0.0 })
    }

    fn transfer_matrix<S: Frequency<T> + Single>(&self, x: S) -> Matrix4<S> {
        Transfer::new(&self.at(x.lambda_squared())).matrix(&self.parameters.map(S::from_parameter))
    }

    fn compound<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
        GeneralCompound::new(self.at(at.lambda_squared), self.units())
    }

    fn back_through<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> BackThrough<S> {
        BackThrough::new(Transfer::new(&self.at(at.lambda_squared)), &self.parameters.map(S::from_parameter))
    }

    /// Its numbers.
    fn numbers(&self) -> BeamNumbers {
        BeamNumbers {
            length: self.parameters.length.words(),
            bending_stiffness: self.parameters.bending_stiffness.words(),
            mass_per_length: self.parameters.mass_per_length.words(),
            axial_stiffness: [0.0; 2],
            shear_stiffness: self.shear_stiffness.words(),
            rotary_inertia: self.parameters.rotary_inertia.words(),
            axial_force: self.parameters.axial_force.words(),
            shear_layer: self.parameters.foundation_shear_stiffness.words(),
            foundation_stiffness: self.parameters.foundation_stiffness.words(),
        }
    }

    /// The parameters in other numbers: in extended precision the inverse of the shear stiffness has all digits of these.
    #[inline]
    fn parameters_in<S: Frequency<T>>(&self) -> BeamParameters<S> {
        let rounded = self.parameters.map(S::from_parameter);
        if !S::IS_EXTENDED || self.shear_stiffness.vanishes().all() {
            return rounded;
        }
        BeamParameters { shear_flexibility: S::one() / S::from_parameter(self.shear_stiffness), ..rounded }
    }

    /// The constants of the equations at a frequency. In extended precision they are computed anew, since `build` has rounded.
    #[inline]
    fn at<S: Frequency<T>>(&self, lambda_squared: S) -> SectionAt<S> {
        if S::IS_EXTENDED {
            return Constants::of(self.parameters_in()).at(lambda_squared);
        }
        self.constants.map(S::from_parameter).at(lambda_squared)
    }

    /// The units of minors.
    #[inline]
    fn units<S: Frequency<T>>(&self) -> Units<S> {
        let BeamParameters { length, bending_stiffness, .. } = self.parameters;
        if S::IS_EXTENDED {
            return Units::new(S::from_parameter(bending_stiffness), S::one() / S::from_parameter(length));
        }
        self.units.map(S::from_parameter)
    }
}

#[cfg(test)]
mod tests;

//! Rigid body that is given by its inertia about its mass centre.

use crate::element::{BackTransfer, Element, Energies, MatrixOf, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::body::{Body, BuiltBody, Inertia};
use crate::elements::shared::axial_force::{AxialForce, before_stiffness, stiffened, under_axial_force};
use crate::elements::shared::same_built::{forms_as, steps_as};
use crate::model::{Bending, Ends, Extent, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scaled, Single};
use crate::subspace::{Covector, RootCounter, Subspace};
use mstmm_plan::Support;
use nalgebra::Matrix4;

/// Rigid body in a bending path whose inertia is about its mass centre: a [`Body`] with `J_I = J_C + m c1²`.
///
/// What is built keeps J_C as it was given.
///
/// # Source
/// Eq. (16) of the paper, and Steiner's theorem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CentralBody<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J_C about the mass centre [kg m²], zero or positive.
    pub inertia: T,
    /// Position b1 of the output end from the input end \[m\].
    pub output_x: T,
    /// Position c1 of the mass centre from the input end \[m\].
    pub centre_x: T,
}

impl<T: Parameter> Element for CentralBody<T> {
    type State = Bending;
    type Built = BuiltBody<T>;

    fn build(self) -> Result<BuiltBody<T>, InvalidParameter> {
        let CentralBody { mass, inertia, output_x, centre_x } = self;
        Requirement::NonNegative.check("mass", mass)?;
        Requirement::NonNegative.check("inertia", inertia)?;
        Requirement::Finite.check("output_x", output_x)?;
        Requirement::Finite.check("centre_x", centre_x)?;
        if Requirement::Finite.check("mass", mass * centre_x * centre_x).is_err() {
            let (parameter, value, requirement) = ("mass", mass.to_f64(), Requirement::Rescale);
            return Err(InvalidParameter { parameter, value, requirement });
        }
        Ok(BuiltBody::new(mass, Inertia::AboutCentre(inertia), [output_x, centre_x]))
    }

    fn estimate(built: &BuiltBody<T>, estimates: &mut FrequencyEstimates) {
        Body::estimate(built, estimates);
    }

    fn extent(built: &BuiltBody<T>) -> Extent {
        Body::extent(built)
    }

    fn member_numbers(built: &BuiltBody<T>) -> MemberNumbers {
        Body::member_numbers(built)
    }
}

steps_as!(CentralBody as Body);

impl<T: Real, S: Oscillation<T>> Energies<S> for CentralBody<T> {
    type Gradient = CentralBody<S>;

    forms_as!(Body);

    /// `J_I = J_C + m c²` follows the mass and its position.
    fn gradient(built: &BuiltBody<T>, ends: &Ends<S>) -> CentralBody<S> {
        let Body { mass, inertia, output_x, centre_x } = Body::gradient(built, ends);
        let arm = built.levers.centre;
        let (by_mass, by_centre) = (arm.times(arm.times(inertia)), arm.times(inertia * built.mass));
        CentralBody { mass: mass + by_mass, inertia, output_x, centre_x: centre_x + by_centre + by_centre }
    }
}

under_axial_force! {
    /// Rigid body in a bending path under an axial force N between its ends, by its inertia about its mass centre.
    ///
    /// Transfer matrix on `[Y, Θ, M, Q]`: that of [`CentralBody`], plus the geometric stiffness `N |b1|` at (M, Θ).
    ///
    /// # Source
    /// Eq. (16) of the paper, and the second variation of the work of N.
    CentralBodyColumn of CentralBody {
        /// Mass m \[kg\], zero or positive.
        mass,
        /// Moment of inertia J_C about the mass centre [kg m²], zero or positive.
        inertia,
        /// Position b1 of the output end from the input end \[m\].
        output_x,
        /// Position c1 of the mass centre from the input end \[m\].
        centre_x,
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for CentralBody<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        CentralBody { mass: next(), inertia: next(), output_x: next() - 1.0, centre_x: next() - 1.0 }
    }
}

#[cfg(test)]
impl crate::elements::laws::Sample for CentralBodyColumn<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let CentralBody { mass, inertia, output_x, centre_x } = CentralBody::sample(&mut next);
        CentralBodyColumn { mass, inertia, output_x, centre_x, axial_force: next() - 1.0 }
    }

    fn untied(self) -> Self {
        CentralBodyColumn { axial_force: 0.0, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A heavy mass on a long arm: the inertia about the input end would have lost that about the centre.
    #[test]
    fn a_small_inertia_about_a_far_centre_is_kept_as_it_is_given() {
        let body = CentralBody { mass: 1e8, inertia: 1e-12, output_x: 0.0, centre_x: 3.0 }.build().unwrap();
        assert_eq!(body.central_inertia, 1e-12);
        let about_input = 1e8 * 9.0 + 1e-12;
        assert_eq!(about_input, 9e8);
    }

    #[test]
    fn a_moment_of_mass_beyond_all_numbers_is_refused() {
        let error = CentralBody { mass: 1e300, inertia: 1.0, output_x: 0.0, centre_x: 1e9 }.build().unwrap_err();
        assert_eq!((error.parameter, error.value, error.requirement), ("mass", 1e300, Requirement::Rescale));
    }
}

//! Rotary inertia.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{displacements, half, inertial_motion, unit_of};
use crate::elements::shared::line_step::through_inertia;
use crate::model::ends::Ends;
use crate::model::error::{InvalidParameter, Requirement};
use crate::model::estimates::FrequencyEstimates;
use crate::model::state::{Coordinate, Rotation};
use crate::number::frequency::Oscillation;
use crate::number::frequency::{Frequency, Real};
use crate::number::frequency_powers::FrequencyPowers;
use crate::subspace::count::RootCounter;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use nalgebra::Matrix2;

/// Rotary inertia on a rotation path.
///
/// Transfer matrix on `[Θ, M]`: `[[1, 0], [Jλ², 1]]`.
///
/// # Source
/// The rotation of a rigid body, eq. (15) of the paper with `b = c = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia<T> {
    /// Moment of inertia J [kg m²], zero or positive.
    pub inertia: T,
}

impl<T: Real> Element for Inertia<T> {
    type State = Rotation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("inertia", self.inertia)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.moment_of_inertia(built.inertia.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Inertia<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
        Matrix2::new(S::one(), S::zero(), x.lambda_squared() * built.inertia, S::one())
    }
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Inertia<T> {
    const BRANCH_FREE: bool = true;
    type Coefficients = S;

    #[inline(always)]
    fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
        at.lambda_squared * built.inertia
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &S, input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
        through_inertia(*coefficients, input)
    }
}

inertial_motion!(Inertia, Theta, inertia);

#[cfg(test)]
impl super::laws::Sample for Inertia<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Inertia { inertia: next() }
    }
}

//! Lumped mass.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{displacements, half, inertial_motion, unit_of};
use crate::elements::shared::line_step::through_inertia;
use crate::model::ends::Ends;
use crate::model::error::{InvalidParameter, Requirement};
use crate::model::estimates::FrequencyEstimates;
use crate::model::state::{Coordinate, Translation};
use crate::number::frequency::Oscillation;
use crate::number::frequency::{Frequency, Real};
use crate::number::frequency_powers::FrequencyPowers;
use crate::subspace::count::RootCounter;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use nalgebra::Matrix2;

/// Lumped mass without moment effects on a translation path.
///
/// Transfer matrix on `[Y, Q]`: `[[1, 0], [-mλ², 1]]`.
///
/// # Source
/// Eq. (5) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
}

impl<T: Real> Element for Mass<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.mass(built.mass.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Mass<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
        Matrix2::new(S::one(), S::zero(), -(x.lambda_squared() * built.mass), S::one())
    }
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Mass<T> {
    const BRANCH_FREE: bool = true;
    type Coefficients = S;

    #[inline(always)]
    fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
        at.lambda_squared * built.mass
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &S, input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
        through_inertia(*coefficients, input)
    }
}

inertial_motion!(Mass, Y, mass);

#[cfg(test)]
impl super::laws::Sample for Mass<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Mass { mass: next() }
    }
}

//! Translational spring.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{back_through_stiffness, elongations, half, massless_motion, unit_of};
use crate::elements::shared::line_step::through_stiffness;
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

/// Massless translational spring, `Q = K (Y_I - Y_O)`.
///
/// Transfer matrix on `[Y, Q]`: `[[1, -1/K], [0, 1]]`.
///
/// # Source
/// Eq. (3) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T> {
    /// Stiffness K [N/m], positive, with a finite reciprocal.
    pub stiffness: T,
}

impl<T: Real> Element for Spring<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Invertible.check("stiffness", self.stiffness)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.translational_stiffness(built.stiffness.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Spring<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix2<S> {
        let compliance = S::from_parameter(T::one() / built.stiffness);
        Matrix2::new(S::one(), -compliance, S::zero(), S::one())
    }
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for Spring<T> {
    const BRANCH_FREE: bool = true;
    type Coefficients = S;

    #[inline(always)]
    fn coefficients(built: &Self, _at: &FrequencyPowers<S>) -> S {
        S::from_parameter(built.stiffness)
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        through_stiffness(*coefficients, input, counter)
    }
}

massless_motion!(Spring, Y, Frequency, [stiffness], []);

#[cfg(test)]
impl super::laws::Sample for Spring<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Spring { stiffness: next() }
    }
}

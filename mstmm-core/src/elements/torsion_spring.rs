//! Torsion spring.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{back_through_stiffness, elongations, half, massless_motion, unit_of};
use crate::elements::shared::line_step::through_stiffness;
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

/// Massless torsion spring, `M = K (Θ_O - Θ_I)`; mind the sign, which is opposite to that of a translational spring.
///
/// Transfer matrix on `[Θ, M]`: `[[1, 1/K], [0, 1]]`.
///
/// # Source
/// Eq. (4) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionSpring<T> {
    /// Stiffness K [N m/rad], positive, with a finite reciprocal.
    pub stiffness: T,
}

impl<T: Real> Element for TorsionSpring<T> {
    type State = Rotation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Invertible.check("stiffness", self.stiffness)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.torsional_stiffness(built.stiffness.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for TorsionSpring<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix2<S> {
        let compliance = S::from_parameter(T::one() / built.stiffness);
        Matrix2::new(S::one(), compliance, S::zero(), S::one())
    }
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for TorsionSpring<T> {
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

massless_motion!(TorsionSpring, Theta, Frequency, [stiffness], []);

#[cfg(test)]
impl super::laws::Sample for TorsionSpring<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        TorsionSpring { stiffness: next() }
    }
}

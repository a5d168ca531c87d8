//! Translational damper.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{back_through_stiffness, elongations, half, massless_motion, unit_of};
use crate::elements::shared::line_step::through_stiffness;
use crate::elements::shared::reciprocal::off_pole;
use crate::model::ends::Ends;
use crate::model::error::{InvalidParameter, Requirement};
use crate::model::estimates::FrequencyEstimates;
use crate::model::state::{Coordinate, Translation};
use crate::number::frequency::Oscillation;
use crate::number::frequency::{ComplexFrequency, Real};
use crate::number::frequency_powers::FrequencyPowers;
use crate::subspace::count::RootCounter;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use nalgebra::Matrix2;

/// Massless viscous damper, `Q = Cλ (Y_I - Y_O)`.
///
/// Transfer matrix on `[Y, Q]`: `[[1, -1/κ], [0, 1]]` with the dynamic stiffness `κ = Cλ`, whose zero is the
/// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
///
/// # Source
/// Eq. (6) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper<T> {
    /// Damping C [N s/m], zero or positive.
    pub damping: T,
}

impl<T: Real> Element for Damper<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("damping", self.damping)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.translational_damping(built.damping.to_f64());
    }
}

impl<T: Real, S: ComplexFrequency<T>> TransferMatrix<S> for Damper<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
        let (_, compliance) = off_pole(built.dynamic_stiffness(x));
        Matrix2::new(S::one(), -compliance, S::zero(), S::one())
    }

    #[inline(always)]
    fn denominator(built: &Self, x: S) -> Option<S> {
        Some(off_pole(built.dynamic_stiffness(x)).0)
    }
}

impl<T: Real> Damper<T> {
    /// `κ = Cλ`.
    #[inline(always)]
    fn dynamic_stiffness<S: ComplexFrequency<T>>(&self, x: S) -> S {
        x * self.damping
    }
}

impl<T: Real, S: ComplexFrequency<T>> PlaneStep<S> for Damper<T> {
    const BRANCH_FREE: bool = true;
    type Coefficients = S;

    #[inline(always)]
    fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> S {
        built.dynamic_stiffness(at.x)
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &S, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        through_stiffness(*coefficients, input, counter)
    }
}

massless_motion!(Damper, Y, ComplexFrequency, [], [damping]);

#[cfg(test)]
impl super::laws::Sample for Damper<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Damper { damping: next() }
    }
}

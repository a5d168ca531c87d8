//! Torsion spring and torsion damper in parallel.

use crate::element::energies::Energies;
use crate::element::traits::{Element, PlaneStep, TransferMatrix};
use crate::elements::shared::line_energies::{back_through_stiffness, elongations, half, massless_motion, unit_of};
use crate::elements::shared::line_step::through_stiffness;
use crate::elements::shared::reciprocal::off_pole;
use crate::model::ends::Ends;
use crate::model::error::{InvalidParameter, Requirement};
use crate::model::estimates::FrequencyEstimates;
use crate::model::state::{Coordinate, Rotation};
use crate::number::frequency::Oscillation;
use crate::number::frequency::{ComplexFrequency, Real};
use crate::number::frequency_powers::FrequencyPowers;
use crate::subspace::count::RootCounter;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use nalgebra::Matrix2;

/// Massless torsion spring and viscous torsion damper in parallel, `M = (K + Cλ)(Θ_O - Θ_I)`.
///
/// Transfer matrix on `[Θ, M]`: `[[1, 1/κ], [0, 1]]` with the dynamic stiffness `κ = K + Cλ`, whose zero is the
/// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
///
/// # Source
/// Eq. (39) of the paper, on rotations as in eq. (4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionSpringDamper<T> {
    /// Stiffness K [N m/rad], positive, with a finite reciprocal.
    pub stiffness: T,
    /// Damping C [N m s/rad], zero or positive.
    pub damping: T,
}

impl<T: Real> Element for TorsionSpringDamper<T> {
    type State = Rotation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Invertible.check("stiffness", self.stiffness)?;
        Requirement::NonNegative.check("damping", self.damping)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.torsional_stiffness(built.stiffness.to_f64());
        estimates.torsional_damping(built.damping.to_f64());
    }
}

impl<T: Real, S: ComplexFrequency<T>> TransferMatrix<S> for TorsionSpringDamper<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, x: S) -> Matrix2<S> {
        let (_, compliance) = off_pole(built.dynamic_stiffness(x));
        Matrix2::new(S::one(), compliance, S::zero(), S::one())
    }

    #[inline(always)]
    fn denominator(built: &Self, x: S) -> Option<S> {
        Some(off_pole(built.dynamic_stiffness(x)).0)
    }
}

impl<T: Real> TorsionSpringDamper<T> {
    /// `κ = K + Cλ`.
    #[inline(always)]
    fn dynamic_stiffness<S: ComplexFrequency<T>>(&self, x: S) -> S {
        S::from_parameter(self.stiffness) + x * self.damping
    }
}

impl<T: Real, S: ComplexFrequency<T>> PlaneStep<S> for TorsionSpringDamper<T> {
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

massless_motion!(TorsionSpringDamper, Theta, ComplexFrequency, [stiffness], [damping]);

#[cfg(test)]
impl super::laws::Sample for TorsionSpringDamper<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        TorsionSpringDamper { stiffness: next(), damping: next() }
    }
}

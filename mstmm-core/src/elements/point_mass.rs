//! Lumped mass inside a bending path.

use crate::element::{BackTransfer, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::line_forms::{displacements, half};
use crate::model::{Bending, Ends, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::subspace::{Covector, Plane, RootCounter, Subspace, in_parallel};
use mstmm_plan::{Coordinate, Support};
use nalgebra::Matrix4;

/// Lumped mass with rotary inertia inside a bending path: a rigid body of no length.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `Jλ²` at (M, Θ) and `-mλ²` at (Q, Y).
///
/// # Source
/// Eq. (16) of the paper with `b = c = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J [kg m²], zero or positive.
    pub inertia: T,
}

impl<T: Parameter> Element for PointMass<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::NonNegative.check("inertia", self.inertia)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.mass(built.mass.to_f64());
        estimates.moment_of_inertia(built.inertia.to_f64());
    }

    fn member_numbers(built: &Self) -> MemberNumbers {
        MemberNumbers::mass([built.mass, built.inertia])
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for PointMass<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, x: S) -> Matrix4<S> {
        let mut u = Matrix4::identity();
        u[(2, 1)] = x.lambda_squared() * built.inertia;
        u[(3, 0)] = -(x.lambda_squared() * built.mass);
        u
    }
}

/// `a = mλ²` and `j = Jλ²`.
#[derive(Clone, Copy, Debug)]
pub struct PointMassCoefficients<S> {
    pub(super) a: S,
    pub(super) j: S,
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for PointMass<T> {
    type Coefficients = PointMassCoefficients<S>;

    #[inline(always)]
    fn coefficients(built: &Self, at: &FrequencyPowers<S>) -> PointMassCoefficients<S> {
        PointMassCoefficients { a: at.lambda_squared * built.mass, j: at.lambda_squared * built.inertia }
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, _counter: &mut C) -> Subspace<S> {
        let PointMassCoefficients { a, j } = *coefficients;
        match input {
            Subspace::Tip(Support::Free, _) => return Subspace::Springs { y: Some(a), theta: Some(j) },
            Subspace::Springs { y, theta } => {
                return Subspace::Springs { y: in_parallel(y, Some(a)), theta: in_parallel(theta, Some(j)) };
            }
            _ => {}
        }
        let p = input.plane();
        let theta_q = p.theta_q + a * p.y_theta;
        let minors = [p.y_theta, p.y_m + j * p.y_theta, p.w, theta_q, p.m_q + a * p.y_m + j * theta_q];
        Subspace::Plane(Plane::new(minors, p.exponent))
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for PointMass<T> {
    type BackCoefficients = PointMassCoefficients<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self) -> Self {
        *built
    }

    fn back_coefficients(built: &Self, at: &FrequencyPowers<S>) -> PointMassCoefficients<S> {
        Self::coefficients(built, at)
    }

    fn back_transfer(
        coefficients: &PointMassCoefficients<S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        Covector::Plane([y - coefficients.a * q, theta + coefficients.j * m, m, q], exponent)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for PointMass<T> {
    type Gradient = PointMass<S>;

    fn units(built: &Self, at: &FrequencyPowers<S>) -> [f64; 2] {
        let PointMassCoefficients { a, j } = Self::coefficients(built, at);
        [S::size(a), S::size(j)]
    }

    fn mass_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        displacements(Coordinate::Y, first, second) * built.mass
            + displacements(Coordinate::Theta, first, second) * built.inertia
    }

    fn stiffness_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn gradient(_built: &Self, ends: &Ends<S>) -> PointMass<S> {
        let form = |coordinate| ends.x.lambda_squared() * half(displacements(coordinate, ends, ends));
        PointMass { mass: form(Coordinate::Y), inertia: form(Coordinate::Theta) }
    }
}

#[cfg(test)]
impl super::laws::Sample for PointMass<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        PointMass { mass: next(), inertia: next() }
    }
}

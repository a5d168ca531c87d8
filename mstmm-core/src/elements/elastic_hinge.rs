//! Elastic hinge in a bending path.

use crate::element::{BackTransfer, Element, Energies, MemberNumbers, PlaneStep, TransferMatrix};
use crate::elements::shared::line_forms::{elongations, half};
use crate::model::{Bending, Ends, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scaled, Single, Size, Truth};
use crate::subspace::{Connecting, Covector, Held, Plane, RootCounter, Subspace};
use mstmm_plan::{Coordinate, Freedoms, Support};
use nalgebra::Matrix4;

/// Massless elastic hinge: a translational and a torsion spring side by side in a bending path.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-1/K_y` at (Y, Q) and `1/K_θ` at (Θ, M).
///
/// # Source
/// Eq. (32) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticHinge<T> {
    /// Translational stiffness K_y [N/m], positive, with a finite reciprocal.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], positive, with a finite reciprocal.
    pub stiffness_theta: T,
}

impl<T: Parameter> Element for ElasticHinge<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Invertible.check("stiffness_y", self.stiffness_y)?;
        Requirement::Invertible.check("stiffness_theta", self.stiffness_theta)?;
        Ok(self)
    }

    fn estimate(built: &Self, estimates: &mut FrequencyEstimates) {
        estimates.translational_stiffness(built.stiffness_y.to_f64());
        estimates.torsional_stiffness(built.stiffness_theta.to_f64());
    }

    fn member_numbers(built: &Self) -> MemberNumbers {
        let [y, theta] = [built.stiffness_y, built.stiffness_theta].map(T::words);
        MemberNumbers::Joint(Freedoms::NONE, [[0.0; 2], y, theta])
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for ElasticHinge<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix4<S> {
        let mut u = Matrix4::identity();
        u[(0, 3)] = -S::from_parameter(T::one() / built.stiffness_y);
        u[(1, 2)] = S::from_parameter(T::one() / built.stiffness_theta);
        u
    }
}

/// The two stiffnesses and their product. The product is rounded in the precision of the evaluation, so that extended precision
/// is about the hinge that was given.
#[derive(Clone, Copy, Debug)]
pub struct HingeCoefficients<T, S> {
    k_y: T,
    k_theta: T,
    product: S,
}

impl<T: Parameter, S: Frequency<T>> PlaneStep<S> for ElasticHinge<T> {
    type Coefficients = HingeCoefficients<T, S>;

    #[inline(always)]
    fn coefficients(built: &Self, _at: &FrequencyPowers<S>) -> HingeCoefficients<T, S> {
        let (k_y, k_theta) = (built.stiffness_y, built.stiffness_theta);
        HingeCoefficients { k_y, k_theta, product: S::from_parameter(k_y) * k_theta }
    }

    #[inline(always)]
    fn step<C: RootCounter<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, counter: &mut C) -> Subspace<S> {
        if let Subspace::Tip(Support::Fixed, _) = input {
            let (y, theta) = (S::from_parameter(coefficients.k_y), S::from_parameter(coefficients.k_theta));
            return Subspace::Springs { y: Some(y), theta: Some(theta) };
        }
        let before = input.plane();
        let after = coefficients.through(&before).in_range();
        let stiffness = [S::from_parameter(coefficients.k_y), S::one()];
        let held = Held { below: S::Size::of(0.0), is_negative: S::Truth::of(false), stiffness, units: None };
        counter.plane(&before, &after, held);
        Subspace::Plane(after)
    }

    #[inline(always)]
    fn root<C: RootCounter<S>>(
        coefficients: &Self::Coefficients,
        input: Subspace<S>,
        support: Support,
        counter: &mut C,
    ) -> Scaled<S> {
        if C::COUNTS || matches!(input, Subspace::Tip(..)) {
            return Self::step(coefficients, input, counter).at_root(support, counter);
        }
        // not shifted into the range: only one minor is needed
        let plane = coefficients.through(&input.plane());
        Scaled::new(plane.minor_at(support), i64::from(plane.exponent))
    }
}

impl<T: Parameter, S: Frequency<T>> HingeCoefficients<T, S> {
    /// Takes a plane through the hinge.
    #[inline(always)]
    fn through(&self, p: &Plane<S>) -> Plane<S> {
        let HingeCoefficients { k_y, k_theta, product } = *self;
        let minors = [
            p.y_theta * product + p.y_m * k_y + p.theta_q * k_theta + p.m_q,
            p.y_m * product + p.m_q * k_theta,
            p.w * product,
            p.theta_q * product + p.m_q * k_y,
            p.m_q * product,
        ];
        Plane::unscaled(minors, p.exponent)
    }
}

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for ElasticHinge<T> {
    type BackCoefficients = HingeCoefficients<T, S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &Self) -> Self {
        *built
    }

    fn back_coefficients(built: &Self, at: &FrequencyPowers<S>) -> HingeCoefficients<T, S> {
        Self::coefficients(built, at)
    }

    /// `K_y K_θ Uᵀ η`, since the step multiplies by the stiffnesses.
    fn back_transfer(
        coefficients: &HingeCoefficients<T, S>,
        _input: &Subspace<S>,
        covector: Covector<S>,
    ) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let HingeCoefficients { k_y, k_theta, product } = *coefficients;
        let entries = [y * product, theta * product, m * product + theta * k_y, q * product - y * k_theta];
        Covector::Plane(entries, exponent)
    }
}

impl<T: Real, S: Oscillation<T>> Energies<S> for ElasticHinge<T> {
    type Gradient = ElasticHinge<S>;

    fn units(built: &Self, _at: &FrequencyPowers<S>) -> [f64; 2] {
        [built.stiffness_y.to_f64(), built.stiffness_theta.to_f64()]
    }

    fn mass_form(_built: &Self, _first: &Ends<S>, _second: &Ends<S>) -> S {
        S::zero()
    }

    fn stiffness_form(built: &Self, first: &Ends<S>, second: &Ends<S>) -> S {
        elongations(Coordinate::Y, first, second) * built.stiffness_y
            + elongations(Coordinate::Theta, first, second) * built.stiffness_theta
    }

    fn gradient(_built: &Self, ends: &Ends<S>) -> ElasticHinge<S> {
        let form = |coordinate| half(elongations(coordinate, ends, ends));
        ElasticHinge { stiffness_y: form(Coordinate::Y), stiffness_theta: form(Coordinate::Theta) }
    }
}

#[cfg(test)]
impl super::laws::Sample for ElasticHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        ElasticHinge { stiffness_y: next(), stiffness_theta: next() }
    }
}

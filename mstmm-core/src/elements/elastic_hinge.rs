//! Elastic hinge in a bending path.

use crate::at::At;
use crate::bounds::FrequencyBounds;
use crate::count::Tally;
use crate::element::{Element, PlaneStep, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::{Bending, Support};
use crate::subspace::{Plane, Subspace};
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

impl<T: Real> Element for ElasticHinge<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Invertible.check("stiffness_y", self.stiffness_y)?;
        Requirement::Invertible.check("stiffness_theta", self.stiffness_theta)?;
        Ok(self)
    }

    fn bound(built: &Self, bounds: &mut FrequencyBounds) {
        bounds.translational_stiffness(built.stiffness_y.to_f64());
        bounds.torsional_stiffness(built.stiffness_theta.to_f64());
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for ElasticHinge<T> {
    #[inline(always)]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix4<S> {
        let mut u = Matrix4::identity();
        u[(0, 3)] = -S::from_parameter(T::one() / built.stiffness_y);
        u[(1, 2)] = S::from_parameter(T::one() / built.stiffness_theta);
        u
    }
}

/// The two stiffnesses and their product.
#[derive(Clone, Copy, Debug)]
pub struct HingeCoefficients<S> {
    k_y: S,
    k_theta: S,
    product: S,
}

impl<T: Real, S: Frequency<T>> PlaneStep<S> for ElasticHinge<T> {
    type Coefficients = HingeCoefficients<S>;

    #[inline(always)]
    fn coefficients(built: &Self, _at: &At<S>) -> HingeCoefficients<S> {
        HingeCoefficients {
            k_y: S::from_parameter(built.stiffness_y),
            k_theta: S::from_parameter(built.stiffness_theta),
            product: S::from_parameter(built.stiffness_y * built.stiffness_theta),
        }
    }

    #[inline(always)]
    fn step<C: Tally<S>>(coefficients: &Self::Coefficients, input: Subspace<S>, tally: &mut C) -> Subspace<S> {
        let HingeCoefficients { k_y, k_theta, product } = *coefficients;
        if let Subspace::Tip(Support::Fixed, _) = input {
            return Subspace::Springs { y: k_y, theta: k_theta };
        }
        let p = input.plane();
        let minors = [
            product * p.y_theta + k_y * p.y_m + k_theta * p.theta_q + p.m_q,
            product * p.y_m + k_theta * p.m_q,
            product * p.w,
            product * p.theta_q + k_y * p.m_q,
            product * p.m_q,
        ];
        let after = Plane::new(minors, p.exponent);
        tally.hinge(&p, &after, k_y);
        Subspace::Plane(after)
    }
}

#[cfg(test)]
impl super::laws::Sample for ElasticHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        ElasticHinge { stiffness_y: next(), stiffness_theta: next() }
    }
}

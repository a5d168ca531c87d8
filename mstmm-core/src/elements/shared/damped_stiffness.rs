//! The dynamic stiffness of a spring with damping.

use crate::element::{Forms, MemberEnds};
use crate::elements::shared::dissipation::{Dissipation, UndampedForms};
use crate::elements::shared::line_forms::half;
use crate::elements::shared::massless::elongation;
use crate::model::{FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{ComplexFrequency, Oscillation, Parameter, Real, Scalar};

/// A spring with damping of its material, and a dashpot beside it, which is the external damping of its elongation.
#[derive(Clone, Copy, Debug)]
pub struct DampedStiffness<T> {
    pub(crate) stiffness: T,
    pub(crate) dissipation: Dissipation<T>,
}

impl<T: Parameter> DampedStiffness<T> {
    /// A spring of stiffness, loss factor, time and damping. What its stiffness needs is known, and what stiffness and damping are called.
    pub(crate) fn new(
        requirement: Requirement,
        [stiffness, loss_factor, time, damping]: [T; 4],
        [stiffness_name, damping_name]: [&'static str; 2],
    ) -> Result<Self, InvalidParameter> {
        requirement.check(stiffness_name, stiffness)?;
        Requirement::NonNegative.check(damping_name, damping)?;
        let dissipation = Dissipation { loss_factor, time, external: damping };
        dissipation.check()?;
        Ok(DampedStiffness { stiffness, dissipation })
    }

    /// The dynamic stiffness `κ = K (1 + iη)(1 + cλ) + dλ`.
    pub(crate) fn at<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        self.dissipation.factor(lambda) * self.stiffness + self.dissipation.external(lambda)
    }

    /// The sum of the sizes of K, Kcλ and dλ: for an overdamped motion κ itself cancels.
    pub(crate) fn size(&self, lambda: f64) -> f64 {
        let [stiffness, damping] = [self.stiffness, self.viscous()].map(T::to_f64);
        stiffness + damping * lambda
    }

    /// The dashpot that its viscous damping is, `Kc + d`.
    pub(crate) fn viscous(&self) -> T {
        self.stiffness * self.dissipation.time + self.dissipation.external
    }

    /// Adds the spring to the estimates.
    pub(crate) fn estimate(
        &self,
        estimates: &mut FrequencyEstimates,
        [stiffness, damping]: [fn(&mut FrequencyEstimates, f64); 2],
    ) {
        stiffness(estimates, self.stiffness.to_f64());
        damping(estimates, self.viscous().to_f64());
        self.dissipation.estimate(estimates);
    }
}

impl<T: Real> DampedStiffness<T> {
    /// The forms of two motions, the first at λ, given the product of their elongations.
    pub(crate) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, elongations: S) -> Forms<S> {
        let none = S::zero();
        let strain = elongations * self.stiffness;
        self.dissipation.forms(lambda, UndampedForms { mass: none, strain, restoring: none, displacement: elongations })
    }

    /// The derivatives of the dynamic work with respect to stiffness, loss factor, time and damping, given the square of the elongation.
    pub(crate) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S, square: S) -> [S; 4] {
        let [loss, time, damping] = self.dissipation.gradient(lambda, [square * self.stiffness, square]);
        [half(square) * self.dissipation.factor_of_motion(lambda), loss, time, damping]
    }

    /// The elongation of a member in a freedom.
    pub(crate) fn elongation<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        motion: &MemberEnds<S>,
        freedom: usize,
    ) -> S {
        let lambda = Scalar::sqrt(motion.x.lambda_squared().size());
        let material = self.dissipation.factor_of_motion(motion.x) * self.stiffness;
        let kappa = material + self.dissipation.external(motion.x);
        elongation(kappa, self.size(lambda), &motion.ends, freedom)
    }
}

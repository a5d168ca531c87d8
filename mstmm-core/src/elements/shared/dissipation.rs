//! What damps a member or a spring: the loss of its material, and a medium around it.

use crate::element::{DampingNumbers, Forms};
use crate::elements::shared::line_forms::half;
use crate::model::{FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{ComplexFrequency, Oscillation, Parameter, Real};

/// Damping of a member: its stiffness is multiplied by `e = (1 + iη)(1 + cλ)`, and a medium resists with `c_e λ` per length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dissipation<T> {
    /// Loss factor η.
    pub(crate) loss_factor: T,
    /// Time c of Kelvin and Voigt.
    pub(crate) time: T,
    /// Damping c_e of the medium per length.
    pub(crate) external: T,
}

/// The forms of two motions of a member, without damping: of mass, of the strain of its material, of what else holds it, and of the
/// displacements alone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct UndampedForms<S> {
    pub(crate) mass: S,
    pub(crate) strain: S,
    pub(crate) restoring: S,
    pub(crate) displacement: S,
}

impl<T: Parameter> Dissipation<T> {
    /// Checks the parameters under the names of all elements.
    pub(crate) fn check(&self) -> Result<(), InvalidParameter> {
        Requirement::NonNegative.check("loss_factor", self.loss_factor)?;
        Requirement::NonNegative.check("kelvin_voigt_time", self.time)?;
        Requirement::NonNegative.check("external_damping", self.external)
    }

    /// The damping as a proof knows it.
    pub(crate) fn numbers(&self) -> DampingNumbers {
        let Dissipation { loss_factor, time, external } = *self;
        DampingNumbers {
            loss_factor: loss_factor.words(),
            time: time.words(),
            viscous: external.words(),
            cross: [[0.0; 2]; 2],
        }
    }

    /// Adds what keeps searches of eigenvalues away to the estimates: the loss factor.
    pub(crate) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        estimates.loss_factor(self.loss_factor.to_f64());
    }

    /// Adds where the stiffness of a member with waves vanishes, `λ = -1/c`, and where it vanishes beside another one, `λ = -share/c`.
    pub(crate) fn estimate_waves(&self, estimates: &mut FrequencyEstimates, share: f64) {
        self.estimate(estimates);
        estimates.essential_singularity(1.0 / self.time.to_f64());
        estimates.essential_singularity(share / self.time.to_f64());
    }

    /// `e(λ)`, which is analytic: for `Im λ < 0` it is not what damps a motion.
    #[inline]
    pub(crate) fn factor<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        (S::one() + imaginary::<T, S>() * self.loss_factor) * (S::one() + lambda * self.time)
    }

    /// `c_e λ`, which adds to the stiffness of a foundation.
    #[inline]
    pub(crate) fn external<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        lambda * self.external
    }
}

impl<T: Real> Dissipation<T> {
    /// The direction of losses in a motion: conjugate motions have conjugate factors.
    fn direction<S: ComplexFrequency<T> + Oscillation<T>>(lambda: S) -> S {
        let upwards = imaginary::<T, S>();
        if lambda.to_complex().im < T::zero() { -upwards } else { upwards }
    }

    /// `1 + iη` of a motion.
    fn loss<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S) -> S {
        S::one() + Self::direction(lambda) * self.loss_factor
    }

    /// `e` of a motion.
    pub(crate) fn factor_of_motion<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S) -> S {
        self.loss(lambda) * (S::one() + lambda * self.time)
    }

    /// The forms of two motions, the first of them at λ: the work `V + λ² T + λ D` has the loss factor in its stiffness form and both other
    /// parameters in its damping form.
    pub(crate) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        lambda: S,
        parts: UndampedForms<S>,
    ) -> Forms<S> {
        let UndampedForms { mass, strain, restoring, displacement } = parts;
        let strain = self.loss(lambda) * strain;
        Forms { mass, stiffness: strain + restoring, damping: strain * self.time + displacement * self.external }
    }

    /// `∂L/∂p` for the loss factor, the time and the external damping, given the forms of strain and of displacements of a motion at λ.
    pub(crate) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        lambda: S,
        [strain, displacement]: [S; 2],
    ) -> [S; 3] {
        let strain = half(strain);
        [
            strain * Self::direction(lambda) * (S::one() + lambda * self.time),
            strain * lambda * self.loss(lambda),
            half(displacement) * lambda,
        ]
    }
}

/// i: `ω = -iλ`.
fn imaginary<T, S: ComplexFrequency<T>>() -> S {
    -S::one().omega()
}

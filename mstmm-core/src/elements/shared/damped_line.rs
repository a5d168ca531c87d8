//! Lines with damping: rods, shafts and strings, and members that stretch.

use crate::element::{Forms, Inside};
use crate::elements::shared::dissipation::{Dissipation, UndampedForms};
use crate::elements::shared::line_forms::half;
use crate::elements::shared::longitudinal_chart::LongitudinalWaves;
use crate::elements::shared::rod_motion::Stretch;
use crate::elements::shared::uniform_line::{LineSection, LineWaves, UniformLine};
use crate::model::FrequencyEstimates;
use crate::number::gauss::integrals;
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real};

/// A line with damping: the line whose stiffness is `H e(λ)` and whose foundation is `k + c_e λ`.
#[derive(Clone, Copy, Debug)]
pub struct DampedLine<T> {
    pub(crate) line: UniformLine<T>,
    pub(crate) dissipation: Dissipation<T>,
}

impl<T: Parameter> DampedLine<T> {
    /// What the line is made of at λ.
    fn at<S: ComplexFrequency<T>>(&self, lambda: S) -> LineSection<S> {
        let section = self.line.section.map(S::from_parameter);
        LineSection {
            stiffness: self.dissipation.factor(lambda) * section.stiffness,
            foundation: section.foundation + self.dissipation.external(lambda),
            ..section
        }
    }

    /// The waves at a frequency without their functions, of a line of a length.
    pub(crate) fn longitudinal<S: ComplexFrequency<T>>(
        &self,
        at: &FrequencyPowers<S>,
        length: S,
    ) -> LongitudinalWaves<S> {
        LineSection { length, ..self.at(at.x) }.waves_at(at.lambda_squared)
    }

    /// The line at a frequency.
    pub(crate) fn waves<S: ComplexFrequency<T>>(&self, at: &FrequencyPowers<S>) -> LineWaves<S> {
        let LongitudinalWaves { square, stiffness } =
            self.longitudinal(at, S::from_parameter(self.line.section.length));
        LineWaves::new(square, [stiffness, S::one() / stiffness])
    }

    /// Adds the line to the estimates as [`UniformLine::estimate`] does, and its damping.
    pub(crate) fn estimate(
        &self,
        estimates: &mut FrequencyEstimates,
        [stiffness, inertia]: [fn(&mut FrequencyEstimates, f64); 2],
    ) {
        self.line.estimate(estimates, [stiffness, inertia]);
        self.dissipation.estimate_waves(estimates, 1.0);
    }
}

impl<T: Real> DampedLine<T> {
    /// `m λ² + k + c_e λ`.
    fn density<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S) -> S {
        let LineSection { inertia, foundation, .. } = self.line.section;
        lambda.lambda_squared() * inertia + S::from_parameter(foundation) + self.dissipation.external(lambda)
    }

    /// `m λ² + k + c_e λ` over e: that of the line without damping in which the motion is the same, with forces over e.
    fn reduced<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S) -> S {
        self.density(lambda) / self.dissipation.factor_of_motion(lambda)
    }

    /// The length of the line and its wave number.
    pub(crate) fn inside<S: ComplexFrequency<T> + Oscillation<T>>(&self, lambda: S) -> Inside {
        let length = self.line.section.length.to_f64();
        Inside { length, wave_number: self.line.section.zeta_of(self.reduced(lambda)) / length }
    }

    /// Displacement and force at both ends, the force over e.
    fn reduced_ends<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>) -> [[S; 2]; 2] {
        let factor = self.dissipation.factor_of_motion(motion.x);
        motion.ends.map(|[displacement, force]| [displacement, force / factor])
    }

    /// Displacement and force at a distance from the input end, the force over e.
    fn reduced_at<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>, distance: T) -> [S; 2] {
        self.line.section.inside_of(self.reduced(motion.x), &self.reduced_ends(motion), distance)
    }

    /// The work of a load of 1 per length on a motion.
    pub(crate) fn load_work<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        self.line.section.load_work(self.reduced(motion.x), &self.reduced_ends(motion))
    }

    /// Displacement and force at a distance from the input end under a load per length. The line without damping bears the load over e.
    pub(crate) fn state_under<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        motion: &Stretch<S>,
        load: S,
        distance: T,
    ) -> [S; 2] {
        let factor = self.dissipation.factor_of_motion(motion.x);
        let (density, ends) = (self.reduced(motion.x), self.reduced_ends(motion));
        let [displacement, force] = self.line.section.at_under(density, &ends, load / factor, distance);
        [displacement, force * factor]
    }

    /// Displacement and force at a distance from the input end.
    pub(crate) fn state_at<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>, distance: T) -> [S; 2] {
        let [displacement, force] = self.reduced_at(motion, distance);
        [displacement, force * self.dissipation.factor_of_motion(motion.x)]
    }

    /// `[∫ u₁ u₂ dx, ∫ H u₁' u₂' dx]`.
    fn squares<S: ComplexFrequency<T> + Oscillation<T>>(&self, first: &Stretch<S>, second: &Stretch<S>) -> [S; 2] {
        let LineSection { length, stiffness, .. } = self.line.section;
        let waves = [first, second].map(|motion| self.line.section.zeta_of(self.reduced(motion.x)));
        let [displacement, force] = integrals(length, waves[0].max(waves[1]), |distance| {
            let ([u, n], [v, q]) = (self.reduced_at(first, distance), self.reduced_at(second, distance));
            [u * v, n * q]
        });
        [displacement, force * (T::one() / stiffness)]
    }

    /// The forms of two motions.
    pub(crate) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        first: &Stretch<S>,
        second: &Stretch<S>,
    ) -> Forms<S> {
        let [displacement, strain] = self.squares(first, second);
        let LineSection { inertia, foundation, .. } = self.line.section;
        let (mass, restoring) = (displacement * inertia, displacement * foundation);
        self.dissipation.forms(first.x, UndampedForms { mass, strain, restoring, displacement })
    }

    /// The derivatives of the dynamic work with respect to length, stiffness, inertia and foundation, and to the three parameters of
    /// damping, with the displacements at both ends held.
    pub(crate) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>) -> ([S; 4], [S; 3]) {
        let [displacement, strain] = self.squares(motion, motion);
        let factor = self.dissipation.factor_of_motion(motion.x);
        let stiffness = half(strain) * factor * (T::one() / self.line.section.stiffness);
        let inertia = half(displacement) * motion.x.lambda_squared();
        let own = [-half(self.flow(motion)), stiffness, inertia, half(displacement)];
        (own, self.dissipation.gradient(motion.x, [strain, displacement]))
    }

    /// `N²/(H e) - (mλ² + k + c_e λ) u²`, which is constant along the line, at the end where its terms are smaller.
    fn flow<S: ComplexFrequency<T> + Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        let density = self.density(motion.x);
        let flexibility = S::one() / (self.dissipation.factor_of_motion(motion.x) * self.line.section.stiffness);
        let parts = motion.ends.map(|[u, n]| [n * n * flexibility, density * u * u]);
        let [input, output] = parts.map(|[strain, kinetic]| (strain.size() + kinetic.size(), strain - kinetic));
        if input.0 < output.0 { input.1 } else { output.1 }
    }
}

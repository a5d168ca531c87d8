//! A general beam with damping of its material and of a medium around it.

use crate::element::Forms;
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::constants::{Constants, SectionAt};
use crate::elements::general_beam::inside::BeamMotion;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::{BackThrough, Transfer};
use crate::elements::shared::bending_chart::BendingWaves;
use crate::elements::shared::chart_scalar::ChartScalar;
use crate::elements::shared::compound::Units;
use crate::elements::shared::dissipation::Dissipation;
use crate::model::{Ends, FrequencyEstimates};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single};
use crate::structure::Chart;
use nalgebra::Matrix4;

/// A beam with damping: at λ it is the beam with `EI e`, `kGA e` and `k + c_e λ`, `e = (1 + iη)(1 + cλ)`, whose formulas hold for complex
/// parameters as for real ones.
#[derive(Clone, Copy, Debug)]
pub struct BuiltDampedBeam<T> {
    pub(super) beam: BuiltGeneralBeam<T>,
    pub(super) dissipation: Dissipation<T>,
}

impl<T: Parameter> BuiltDampedBeam<T> {
    /// The beam at λ, given `e` and `c_e λ`.
    fn with<S: ComplexFrequency<T>>(&self, factor: S, external: S) -> BeamParameters<S> {
        let beam = self.beam.parameters_in::<S>();
        BeamParameters {
            bending_stiffness: beam.bending_stiffness * factor,
            shear_flexibility: beam.shear_flexibility / factor,
            foundation_stiffness: beam.foundation_stiffness + external,
            ..beam
        }
    }

    /// The beam at λ.
    fn at<S: ComplexFrequency<T>>(&self, lambda: S) -> BeamParameters<S> {
        self.with(self.dissipation.factor(lambda), self.dissipation.external(lambda))
    }

    /// The mass per length.
    pub(super) fn mass_per_length(&self) -> T {
        self.beam.mass_per_length()
    }

    pub(super) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        self.beam.estimate(estimates);
        let BeamParameters { shear_flexibility, .. } = self.beam.parameters;
        // where kGA e + T vanishes
        let share = T::one() + shear_flexibility * self.beam.parameters.tension();
        self.dissipation.estimate_waves(estimates, share.to_f64());
    }

    pub(super) fn transfer_matrix<S: ComplexFrequency<T> + Single>(&self, lambda: S) -> Matrix4<S> {
        let beam = self.at(lambda);
        Transfer::new(&beam.section(lambda.lambda_squared())).matrix(&beam)
    }

    pub(super) fn compound<S: ComplexFrequency<T>>(&self, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
        let beam = self.at(at.x);
        GeneralCompound::new(
            beam.section(at.lambda_squared),
            Units::new(beam.bending_stiffness, S::one() / beam.length),
        )
    }

    pub(super) fn back_through<S: ComplexFrequency<T>>(&self, at: &FrequencyPowers<S>) -> BackThrough<S> {
        let beam = self.at(at.x);
        BackThrough::new(Transfer::new(&beam.section(at.lambda_squared)), &beam)
    }

    /// The chart of a beam of a length, beside a motion along it where that has an impedance.
    pub(super) fn chart<S: ComplexFrequency<T> + ChartScalar>(
        &self,
        at: &FrequencyPowers<S>,
        length: S,
        along: Option<f64>,
    ) -> Chart<S> {
        let (mut chart, places) = self.beam.empty_chart(at.lambda_squared, along);
        let beam = BeamParameters { length, ..self.at(at.x) };
        if self.beam.parameters.bends_only() {
            S::enter_bending(&beam.bending_waves(at.lambda_squared), &mut chart, places);
            return chart;
        }
        let (relation, factors) = beam.relation(at.lambda_squared);
        relation.enter(&mut chart, places, &factors);
        chart
    }
}

impl<S: Scalar> BeamParameters<S> {
    /// Its waves at λ², without shear, rotary inertia or axial force: `z⁴ = -(mλ² + k) l⁴/EI`, of which any root will do.
    fn bending_waves(&self, lambda_squared: S) -> BendingWaves<S> {
        let square = self.length * self.length;
        let inertia = lambda_squared * self.mass_per_length + self.foundation_stiffness;
        let z_fourth = -(inertia * square * square / self.bending_stiffness);
        let stiffness = self.bending_stiffness / (square * self.length);
        BendingWaves { z_fourth, z: z_fourth.sqrt().sqrt(), stiffness, length: self.length }
    }

    /// The constants of the equations at λ², from the parameters alone.
    fn section(&self, lambda_squared: S) -> SectionAt<S> {
        Constants::of(*self).at(lambda_squared)
    }
}

impl<T: Real> BuiltDampedBeam<T> {
    /// The beam at the frequency of a motion.
    pub(super) fn motion<S: ComplexFrequency<T> + Oscillation<T>>(&self, x: S) -> BeamMotion<T, S> {
        let (loss, external) = (self.dissipation.factor_of_motion(x), self.dissipation.external(x));
        let beam = self.with(loss, external);
        let constants = Constants::of(beam);
        BeamMotion {
            beam: self.beam.parameters,
            x,
            section: Constants::of(beam.map(S::to_complex)).at(x.lambda_squared().to_complex()),
            loss,
            external,
            sigma: constants.sigma,
            flexibility: constants.sigma * beam.shear_flexibility,
        }
    }

    /// The forms of two motions.
    pub(super) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> Forms<S> {
        let parts = self.motion(first.x).forms(first, (&self.motion(second.x), second));
        self.dissipation.forms(first.x, parts)
    }

    /// The derivatives of the dynamic work with respect to the parameters of the beam without damping, and to those of damping: of EI and f
    /// by what `EI e` and `f/e` do.
    pub(super) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        ends: &Ends<S>,
    ) -> (BeamParameters<S>, [S; 3]) {
        let motion = self.motion(ends.x);
        let parts = motion.forms(ends, (&motion, ends));
        let gradient = motion.gradient(ends);
        (gradient, self.dissipation.gradient(ends.x, [parts.strain, parts.displacement]))
    }
}

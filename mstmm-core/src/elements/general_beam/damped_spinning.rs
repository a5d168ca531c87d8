//! A beam that spins with damping of its material, which turns with it, and of a medium around it, which stands still.

use crate::element::Forms;
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::constants::{Constants, SectionAt};
use crate::elements::general_beam::inside::BeamMotion;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::{BackThrough, Transfer};
use crate::elements::shared::compound::Units;
use crate::elements::shared::dissipation::UndampedForms;
use crate::elements::shared::line_forms::half;
use crate::elements::shared::spin::Spin;
use crate::model::{Ends, FrequencyEstimates, InvalidParameter, Requirement};
use crate::number::{ComplexFrequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single, Truth};
use crate::structure::Chart;
use nalgebra::Matrix4;

/// A beam that spins with damping: at λ it is the beam with `EI e`, `kGA e` and `k + c_e λ`, where `e = 1 + t (λ - iΩ)` with the speed Ω as the whirl
/// sees it, and with the gyroscopic moment `H ω`, `ω = -iλ`.
///
/// A motion `e^{λt}` is `e^{(λ - iΩ)t}` for who turns with the shaft.
#[derive(Clone, Copy, Debug)]
pub struct BuiltDampedSpinningBeam<T> {
    pub(super) beam: BuiltGeneralBeam<T>,
    pub(super) spin: Spin<T>,
    /// Time t of Kelvin and Voigt, and damping c_e of the medium per length.
    time: T,
    external: T,
}

impl<T: Parameter> BuiltDampedSpinningBeam<T> {
    pub(super) fn new(
        beam: BuiltGeneralBeam<T>,
        spin: Spin<T>,
        [time, external]: [T; 2],
    ) -> Result<Self, InvalidParameter> {
        Requirement::NonNegative.check("kelvin_voigt_time", time)?;
        Requirement::NonNegative.check("external_damping", external)?;
        Ok(BuiltDampedSpinningBeam { beam, spin, time, external })
    }

    /// The beam seen from the other whirl.
    pub(super) fn turned_round(self) -> Self {
        BuiltDampedSpinningBeam { spin: self.spin.turned_round(), ..self }
    }

    /// Kelvin-Voigt time and external damping, as a proof knows both.
    pub(super) fn damping(&self) -> [[f64; 2]; 2] {
        [self.time.words(), self.external.words()]
    }

    pub(super) fn estimate(&self, estimates: &mut FrequencyEstimates) {
        let rate = 1.0 / self.time.to_f64();
        // where kGA e + T vanishes
        let share = T::one() + self.beam.parameters.shear_flexibility * self.beam.parameters.tension();
        if !(self.time * self.spin.speed).vanishes().all() {
            estimates.whirl();
        }
        estimates.turning_singularity(rate);
        estimates.turning_singularity(rate * share.to_f64());
    }

    /// The mass per length.
    pub(super) fn mass_per_length(&self) -> T {
        self.beam.mass_per_length()
    }

    /// `λ - iΩ`.
    fn turning<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        lambda + S::one().signed_omega() * self.spin.signed_speed()
    }

    /// `e`.
    fn factor<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        S::one() + self.turning(lambda) * self.time
    }

    /// The beam at λ without its gyroscopic moment.
    fn at<S: ComplexFrequency<T>>(&self, lambda: S) -> BeamParameters<S> {
        let (beam, factor) = (self.beam.parameters_in::<S>(), self.factor(lambda));
        BeamParameters {
            bending_stiffness: beam.bending_stiffness * factor,
            shear_flexibility: beam.shear_flexibility / factor,
            foundation_stiffness: beam.foundation_stiffness + lambda * self.external,
            ..beam
        }
    }

    /// `H ω` of the beam at λ.
    fn moment<S: ComplexFrequency<T>>(&self, lambda: S) -> S {
        self.spin.momentum::<S>() * lambda.signed_omega()
    }

    /// The constants of the equations at λ.
    fn section<S: ComplexFrequency<T>>(&self, beam: &BeamParameters<S>, lambda: S) -> SectionAt<S> {
        let scale = beam.length * beam.length / beam.bending_stiffness;
        Constants::of(*beam).with_moment(self.moment(lambda) * scale).at(lambda.lambda_squared())
    }

    pub(super) fn transfer_matrix<S: ComplexFrequency<T> + Single>(&self, lambda: S) -> Matrix4<S> {
        let beam = self.at(lambda);
        Transfer::new(&self.section(&beam, lambda)).matrix(&beam)
    }

    pub(super) fn compound<S: ComplexFrequency<T>>(&self, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
        let beam = self.at(at.x);
        GeneralCompound::new(self.section(&beam, at.x), Units::new(beam.bending_stiffness, S::one() / beam.length))
    }

    pub(super) fn back_through<S: ComplexFrequency<T>>(&self, at: &FrequencyPowers<S>) -> BackThrough<S> {
        let beam = self.at(at.x);
        BackThrough::new(Transfer::new(&self.section(&beam, at.x)), &beam)
    }

    /// The chart of a beam of a length, beside a motion along it where that has an impedance.
    pub(super) fn chart<S: ComplexFrequency<T>>(
        &self,
        at: &FrequencyPowers<S>,
        length: S,
        along: Option<f64>,
    ) -> Chart<S> {
        let (mut chart, places) = self.beam.empty_chart(at.lambda_squared, along);
        let beam = BeamParameters { length, ..self.at(at.x) };
        let scale = length * length / beam.bending_stiffness;
        let (relation, factors) = beam.relation_with_moment(at.lambda_squared, self.moment(at.x) * scale);
        relation.enter(&mut chart, places, &factors);
        chart
    }
}

impl<T: Real> BuiltDampedSpinningBeam<T> {
    /// The beam at the frequency of a motion.
    pub(super) fn motion<S: ComplexFrequency<T> + Oscillation<T>>(&self, x: S) -> BeamMotion<T, S> {
        let beam = self.at(x);
        let constants = Constants::of(beam);
        let complex = beam.map(S::to_complex);
        let scale = complex.length * complex.length / complex.bending_stiffness;
        let moment = self.moment(x).to_complex() * scale;
        BeamMotion {
            beam: self.beam.parameters,
            x,
            section: Constants::of(complex).with_moment(moment).at(x.lambda_squared().to_complex()),
            loss: self.factor(x),
            external: x * self.external,
            sigma: constants.sigma,
            flexibility: constants.sigma * beam.shear_flexibility,
        }
    }

    /// The forms of two motions: what turns with the shaft in the strain is a part of the stiffness form.
    pub(super) fn forms<S: ComplexFrequency<T> + Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> Forms<S> {
        let other = if Spin::is_of_other_whirl([first.x, second.x]) { self.turned_round() } else { *self };
        let (motion, other) = (self.motion(first.x), other.motion(second.x));
        let products = motion.products(first, (&other, second));
        let UndampedForms { mass, strain, restoring, displacement } = motion.forms_of(products, &other);
        let at_rest = self.factor(<S as Scalar>::from_f64(0.0));
        Forms {
            mass,
            stiffness: strain * at_rest + restoring,
            damping: strain * self.time + displacement * self.external + self.spin.form(products.rotation),
        }
    }

    /// The derivatives of the dynamic work with respect to the parameters of the beam at rest, to its damping, to the polar inertia and to the speed.
    pub(super) fn gradient<S: ComplexFrequency<T> + Oscillation<T>>(
        &self,
        ends: &Ends<S>,
    ) -> (BeamParameters<S>, [S; 4]) {
        let motion = self.motion(ends.x);
        let products = motion.products(ends, (&motion, ends));
        let gradient = motion.gradient_of(products, motion.flow(ends, motion.g() + self.moment(ends.x)));
        let UndampedForms { strain, displacement, .. } = motion.forms_of(products, &motion);
        let [polar_inertia, speed] = self.spin.gradient(ends.x, products.rotation);
        // e has -itΩ
        let of_factor = half(strain) * self.time * S::one().signed_omega() * self.spin.sense();
        let (time, external) = (half(strain) * self.turning(ends.x), half(displacement) * ends.x);
        (gradient, [time, external, polar_inertia, speed + of_factor])
    }
}

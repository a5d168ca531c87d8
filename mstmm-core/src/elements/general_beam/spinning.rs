//! A general beam that spins about its axis: gyroscopic moments add to what holds against its rotation.

use crate::element::Forms;
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::compound::GeneralCompound;
use crate::elements::general_beam::constants::{Constants, SectionAt};
use crate::elements::general_beam::inside::BeamMotion;
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::transfer::{BackThrough, Transfer};
use crate::elements::shared::dissipation::UndampedForms;
use crate::elements::shared::spin::Spin;
use crate::model::Ends;
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Single};
use crate::structure::Chart;
use nalgebra::Matrix4;
use num_complex::Complex;

/// A beam that spins: at ω it is the beam whose `g` is greater by `H ω`, with the angular momentum per length `H = ±ρI_p Ω`.
#[derive(Clone, Copy, Debug)]
pub struct BuiltSpinningBeam<T> {
    pub(super) beam: BuiltGeneralBeam<T>,
    pub(super) spin: Spin<T>,
    /// `H l²/EI`.
    momentum: T,
}

impl<T: Parameter> BuiltSpinningBeam<T> {
    pub(super) fn new(beam: BuiltGeneralBeam<T>, spin: Spin<T>) -> Self {
        let BeamParameters { length, bending_stiffness, .. } = beam.parameters;
        let momentum = spin.polar_inertia * spin.signed_speed() * (length * length / bending_stiffness);
        BuiltSpinningBeam { beam, spin, momentum }
    }

    /// The beam seen from the other whirl.
    pub(super) fn turned_round(self) -> Self {
        BuiltSpinningBeam::new(self.beam, self.spin.turned_round())
    }

    /// The constants of the equations at a frequency.
    #[inline]
    fn at<S: Frequency<T>>(&self, x: S, lambda_squared: S) -> SectionAt<S> {
        let omega = x.signed_omega();
        if S::IS_EXTENDED {
            let beam: BeamParameters<S> = self.beam.parameters_in();
            let scale = beam.length * beam.length / beam.bending_stiffness;
            return Constants::of(beam).with_moment(self.spin.momentum::<S>() * scale * omega).at(lambda_squared);
        }
        self.beam.constants.map(S::from_parameter).with_moment(omega * self.momentum).at(lambda_squared)
    }

    /// The mass per length.
    pub(super) fn mass_per_length(&self) -> T {
        self.beam.mass_per_length()
    }

    pub(super) fn transfer_matrix<S: Frequency<T> + Single>(&self, x: S) -> Matrix4<S> {
        let beam = self.beam.parameters.map(S::from_parameter);
        Transfer::new(&self.at(x, x.lambda_squared())).matrix(&beam)
    }

    pub(super) fn compound<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> GeneralCompound<S> {
        GeneralCompound::new(self.at(at.x, at.lambda_squared), self.beam.units())
    }

    pub(super) fn back_through<S: Frequency<T>>(&self, at: &FrequencyPowers<S>) -> BackThrough<S> {
        let beam = self.beam.parameters.map(S::from_parameter);
        BackThrough::new(Transfer::new(&self.at(at.x, at.lambda_squared)), &beam)
    }

    /// The chart of a beam of a length, beside a motion along it where that has an impedance.
    pub(super) fn chart<S: Frequency<T>>(&self, at: &FrequencyPowers<S>, length: S, along: Option<f64>) -> Chart<S> {
        let (mut chart, places) = self.beam.empty_chart(at.lambda_squared, along);
        let beam = BeamParameters { length, ..self.beam.parameters_in() };
        let scale = length * length / beam.bending_stiffness;
        let moment = self.spin.momentum::<S>() * scale * at.x.signed_omega();
        let (relation, factors) = beam.relation_with_moment(at.lambda_squared, moment);
        relation.enter(&mut chart, places, &factors);
        chart
    }
}

impl<T: Real> BuiltSpinningBeam<T> {
    /// The beam at the frequency of a motion.
    pub(super) fn motion<S: Oscillation<T>>(&self, x: S) -> BeamMotion<T, S> {
        let constants = self.beam.constants.map(Complex::from);
        let moment = x.signed_omega().to_complex() * self.momentum;
        let section = constants.with_moment(moment).at(x.lambda_squared().to_complex());
        BeamMotion { section, ..self.beam.motion(x) }
    }

    /// The forms of two motions.
    pub(super) fn forms<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> Forms<S> {
        let other = if Spin::is_of_other_whirl([first.x, second.x]) { self.turned_round() } else { *self };
        let (motion, other) = (self.motion(first.x), other.motion(second.x));
        let products = motion.products(first, (&other, second));
        let UndampedForms { mass, strain, restoring, .. } = motion.forms_of(products, &other);
        Forms { mass, stiffness: strain + restoring, damping: self.spin.form(products.rotation) }
    }

    /// The derivatives of the dynamic work with respect to the parameters of the beam at rest, to the polar inertia and to the speed.
    pub(super) fn gradient<S: Oscillation<T>>(&self, ends: &Ends<S>) -> (BeamParameters<S>, [S; 2]) {
        let motion = self.motion(ends.x);
        let products = motion.products(ends, (&motion, ends));
        let moment = self.spin.momentum::<S>() * ends.x.signed_omega();
        let gradient = motion.gradient_of(products, motion.flow(ends, motion.g() + moment));
        (gradient, self.spin.gradient(ends.x, products.rotation))
    }
}

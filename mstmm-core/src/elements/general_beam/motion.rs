//! The motion of a general beam: its energies and their derivatives with respect to its parameters.

use crate::element::{Deflection, Forms, Inside as Interior};
use crate::elements::general_beam::BuiltGeneralBeam;
use crate::elements::general_beam::inside::{BeamMotion, Inside};
use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::shared::dissipation::UndampedForms;
use crate::elements::shared::line_forms::{half, smaller_sum};
use crate::model::{Ends, State};
use crate::number::gauss::integrals_beside_ends;
use crate::number::{Oscillation, Real};
use num_complex::Complex;

/// The integrals along a beam of products of two motions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Products<S> {
    deflection: S,
    pub(super) rotation: S,
    moment: S,
    /// Of the forces that shear the sections, `V = -Q - T Y'`.
    shear: S,
    /// Of the slopes Y'.
    slope: S,
}

impl<S> Products<S> {
    fn map(self, to: impl Fn(S) -> S) -> Self {
        Products {
            deflection: to(self.deflection),
            rotation: to(self.rotation),
            moment: to(self.moment),
            shear: to(self.shear),
            slope: to(self.slope),
        }
    }
}

impl<T: Real> BuiltGeneralBeam<T> {
    /// The beam at the frequency of a motion.
    pub(super) fn motion<S: Oscillation<T>>(&self, x: S) -> BeamMotion<T, S> {
        let constants = self.constants;
        BeamMotion {
            beam: self.parameters,
            x,
            section: constants.map(Complex::from).at(x.lambda_squared().to_complex()),
            loss: S::one(),
            external: S::zero(),
            sigma: S::from_parameter(constants.sigma),
            flexibility: S::from_parameter(constants.sigma * self.parameters.shear_flexibility),
        }
    }

    /// The forms of two motions.
    pub(super) fn forms<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> Forms<S> {
        let UndampedForms { mass, strain, restoring, .. } =
            self.motion(first.x).forms(first, (&self.motion(second.x), second));
        Forms { mass, stiffness: strain + restoring, ..Forms::none() }
    }
}

impl<T: Real, S: Oscillation<T>> BeamMotion<T, S> {
    /// Usual sizes of forces per displacement, `[Q/Y, M/Θ]`.
    pub(super) fn units(&self) -> [f64; 2] {
        let [length, stiffness] = [self.beam.length, self.beam.bending_stiffness].map(T::to_f64);
        let wave = self.largest_wave().max(1.0) / length;
        [stiffness * wave * wave * wave, stiffness * wave]
    }

    /// The largest wave number times l.
    fn largest_wave(&self) -> f64 {
        self.section.waves.largest_wave()
    }

    /// The length and the largest wave number of what travels: a wave that decays beside an end has no nodes.
    pub(super) fn interior(&self) -> Interior {
        let length = self.beam.length.to_f64();
        Interior { length, wave_number: self.section.waves.largest_travelling() / length }
    }

    /// The state at a distance from the input end.
    pub(super) fn state_at(&self, ends: &Ends<S>, distance: T) -> State<S> {
        Inside::new(self, ends).state_at(distance)
    }

    /// The deflection with given states at both ends.
    pub(super) fn deflection(&self, ends: &Ends<S>) -> Deflection<S> {
        Inside::new(self, ends).deflection()
    }

    /// `∂L/∂EI = ½ e ∫ Θ'²`, `∂L/∂f = -½ ∫ (kGA)² e (Y' - Θ)²`, `∂L/∂T = ½ ∫ Y'²`, `∂L/∂k = ½ ∫ Y²`, `∂L/∂m = ½ λ² ∫ Y²`,
    /// `∂L/∂r = ½ λ² ∫ Θ²`; e is 1 without damping.
    pub(super) fn gradient(&self, ends: &Ends<S>) -> BeamParameters<S> {
        self.gradient_of(self.products(ends, (self, ends)), self.flow(ends, self.g()))
    }

    /// The same for the products of the motion, and `∂L/∂l`.
    pub(super) fn gradient_of(&self, products: Products<S>, length: S) -> BeamParameters<S> {
        let Products { deflection, rotation, moment, shear, slope } = products.map(half);
        let square = self.x.lambda_squared();
        let flexibility = T::one() / self.beam.bending_stiffness;
        BeamParameters {
            length,
            bending_stiffness: moment * (flexibility * flexibility) / self.loss,
            mass_per_length: square * deflection,
            shear_flexibility: -shear / self.loss,
            rotary_inertia: square * rotation,
            axial_force: slope,
            foundation_stiffness: deflection,
            foundation_shear_stiffness: slope,
        }
    }

    /// The slope Y' of a state, and the force that shears its section.
    fn slope_and_shear(&self, state: &State<S>) -> [S; 2] {
        let slope = state.theta * self.sigma - state.q * self.flexibility;
        [slope, -(state.q + slope * self.beam.tension())]
    }

    pub(super) fn products(&self, first: &Ends<S>, (other, second): (&Self, &Ends<S>)) -> Products<S> {
        let (of_one, of_other) = (self.section.waves.decaying(), other.section.waves.decaying());
        let waves = [0, 1].map(|wave| of_one[wave].beside(of_other[wave]));
        let (one, two) = (Inside::new(self, first), Inside::new(other, second));
        let [deflection, rotation, moment, shear, slope] = integrals_beside_ends(self.beam.length, waves, |distance| {
            let u: State<S> = one.state_at(distance);
            let v = if first == second { u } else { two.state_at(distance) };
            let ([slope, shear], [other_slope, other_shear]) = (self.slope_and_shear(&u), other.slope_and_shear(&v));
            [u.y * v.y, u.theta * v.theta, u.m * v.m, shear * other_shear, slope * other_slope]
        });
        Products { deflection, rotation, moment, shear, slope }
    }

    /// The forms of two motions: of mass `∫ m Y₁ Y₂ + r Θ₁ Θ₂`, of strain `∫ EI Θ₁' Θ₂' + f V₁ V₂/(e₁ e₂)`, and of what else holds the beam,
    /// `∫ T Y₁' Y₂' + k Y₁ Y₂`.
    pub(super) fn forms(&self, first: &Ends<S>, (other, second): (&Self, &Ends<S>)) -> UndampedForms<S> {
        self.forms_of(self.products(first, (other, second)), other)
    }

    /// The same for the products of both motions.
    pub(super) fn forms_of(&self, products: Products<S>, other: &Self) -> UndampedForms<S> {
        let Products { deflection, rotation, moment, shear, slope } = products;
        let beam = &self.beam;
        let bending = moment * (T::one() / beam.bending_stiffness) + shear * beam.shear_flexibility;
        UndampedForms {
            mass: deflection * beam.mass_per_length + rotation * beam.rotary_inertia,
            strain: bending / (self.loss * other.loss),
            restoring: slope * beam.tension() + deflection * beam.foundation_stiffness,
            displacement: deflection,
        }
    }

    /// `g = σ T + r λ²`.
    pub(super) fn g(&self) -> S {
        self.x.lambda_squared() * self.beam.rotary_inertia + self.sigma * self.beam.tension()
    }

    /// `∂L/∂l = -½ (M²/(EI e) + f σ/e Q² - 2σ Q Θ - g Θ² + h Y²)`, which is constant along the beam, at the end where its terms are smaller,
    /// since they cancel where waves decay.
    pub(super) fn flow(&self, ends: &Ends<S>, g: S) -> S {
        let beam = &self.beam;
        let square = self.x.lambda_squared();
        let h = -(square * beam.mass_per_length) - S::from_parameter(beam.foundation_stiffness) - self.external;
        smaller_sum([ends.input, ends.output].map(|state| {
            [
                -half(state.m * state.m) * (T::one() / beam.bending_stiffness) / self.loss,
                -half(state.q * state.q) * self.flexibility,
                state.q * state.theta * self.sigma,
                half(g * state.theta * state.theta),
                -half(h * state.y * state.y),
            ]
        }))
    }
}

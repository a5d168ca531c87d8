//! The motion of a general beam: its back transfer, its energies and their derivatives with respect to its parameters.

use crate::element::{BackTransfer, CarriesLoad, Energies, Inside as Interior};
use crate::elements::general_beam::inside::{Inside, section_at};
use crate::elements::general_beam::transfer::{BackThrough, Transfer};
use crate::elements::general_beam::{BuiltGeneralBeam, GeneralBeam};
use crate::elements::shared::gauss::integrals;
use crate::elements::shared::line_forms::half;
use crate::model::{Ends, State};
use crate::number::{FrequencyPowers, Oscillation, Real};
use crate::subspace::{Covector, Subspace};

impl<T: Real, S: Oscillation<T>> BackTransfer<S> for GeneralBeam<T> {
    type BackCoefficients = BackThrough<S>;
    const SYMMETRIC: bool = true;

    fn reversed(built: &BuiltGeneralBeam<T>) -> BuiltGeneralBeam<T> {
        *built
    }

    fn back_coefficients(built: &BuiltGeneralBeam<T>, at: &FrequencyPowers<S>) -> BackThrough<S> {
        let transfer = Transfer::new(&built.at(at.lambda_squared));
        BackThrough::new(transfer, &built.parameters.map(S::from_parameter))
    }

    fn back_transfer(coefficients: &BackThrough<S>, _input: &Subspace<S>, covector: Covector<S>) -> Covector<S> {
        coefficients.back_transfer(covector)
    }
}

impl<T: Real> CarriesLoad for GeneralBeam<T> {}

impl<T: Real, S: Oscillation<T>> Energies<S> for GeneralBeam<T> {
    type Gradient = GeneralBeam<S>;

    fn units(built: &BuiltGeneralBeam<T>, at: &FrequencyPowers<S>) -> [f64; 2] {
        let [length, stiffness] = [built.parameters.length, built.parameters.bending_stiffness].map(T::to_f64);
        let wave = built.largest_wave(at.x).max(1.0) / length;
        [stiffness * wave * wave * wave, stiffness * wave]
    }

    fn mass_form(built: &BuiltGeneralBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second)[0]
    }

    fn stiffness_form(built: &BuiltGeneralBeam<T>, first: &Ends<S>, second: &Ends<S>) -> S {
        built.forms(first, second)[1]
    }

    fn inside(built: &BuiltGeneralBeam<T>, x: S) -> Option<Interior> {
        Some(built.interior(x))
    }

    fn state_at(built: &BuiltGeneralBeam<T>, ends: &Ends<S>, distance: f64) -> State<S> {
        built.state_at(ends, T::from_f64(distance))
    }

    fn load_work(built: &BuiltGeneralBeam<T>, ends: &Ends<S>) -> Option<S> {
        Some(built.load_work(ends))
    }

    fn mass_per_length(built: &BuiltGeneralBeam<T>) -> S {
        S::from_parameter(built.parameters.mass_per_length)
    }

    fn gradient(built: &BuiltGeneralBeam<T>, ends: &Ends<S>) -> GeneralBeam<S> {
        built.gradient(ends)
    }
}

/// The integrals along a beam of products of two motions.
#[derive(Clone, Copy, Debug)]
struct Products<S> {
    deflection: S,
    rotation: S,
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
    /// The largest wave number times l.
    pub(super) fn largest_wave<S: Oscillation<T>>(&self, x: S) -> f64 {
        section_at(self, x).waves.largest_wave()
    }

    /// The length and the largest wave number.
    pub(super) fn interior<S: Oscillation<T>>(&self, x: S) -> Interior {
        let length = self.parameters.length.to_f64();
        Interior { length, wave_number: self.largest_wave(x) / length }
    }

    /// The state at a distance from the input end.
    pub(super) fn state_at<S: Oscillation<T>>(&self, ends: &Ends<S>, distance: T) -> State<S> {
        Inside::new(self, ends).state_at(distance)
    }

    /// `∂L/∂EI = ½ ∫ Θ'²`, `∂L/∂f = -½ ∫ (kGA)² (Y' - Θ)²`, `∂L/∂T = ½ ∫ Y'²`, `∂L/∂k = ½ ∫ Y²`, `∂L/∂m = ½ λ² ∫ Y²`, `∂L/∂r = ½ λ² ∫ Θ²`.
    pub(super) fn gradient<S: Oscillation<T>>(&self, ends: &Ends<S>) -> GeneralBeam<S> {
        let Products { deflection, rotation, moment, shear, slope } = self.products(ends, ends).map(half);
        let square = ends.x.lambda_squared();
        let flexibility = T::one() / self.parameters.bending_stiffness;
        GeneralBeam {
            length: self.flow(ends),
            bending_stiffness: moment * (flexibility * flexibility),
            mass_per_length: square * deflection,
            shear_flexibility: -shear,
            rotary_inertia: square * rotation,
            axial_force: slope,
            foundation_stiffness: deflection,
            foundation_shear_stiffness: slope,
        }
    }

    /// The slope Y' of a state, and the force that shears its section.
    fn slope_and_shear<S: Oscillation<T>>(&self, state: &State<S>) -> [S; 2] {
        let sigma = self.constants.sigma;
        let slope = state.theta * sigma - state.q * (sigma * self.parameters.shear_flexibility);
        [slope, -(state.q + slope * self.parameters.tension())]
    }

    fn products<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> Products<S> {
        let waves = self.largest_wave(first.x).max(self.largest_wave(second.x));
        let (one, other) = (Inside::new(self, first), Inside::new(self, second));
        let [deflection, rotation, moment, shear, slope] = integrals(self.parameters.length, waves, |distance| {
            let u: State<S> = one.state_at(distance);
            let v = if first == second { u } else { other.state_at(distance) };
            let ([slope, shear], [other_slope, other_shear]) = (self.slope_and_shear(&u), self.slope_and_shear(&v));
            [u.y * v.y, u.theta * v.theta, u.m * v.m, shear * other_shear, slope * other_slope]
        });
        Products { deflection, rotation, moment, shear, slope }
    }

    /// Mass and stiffness form of two motions: `∫ m Y₁ Y₂ + r Θ₁ Θ₂`, `∫ M₁ M₂/EI + f V₁ V₂ + T Y₁' Y₂' + k Y₁ Y₂`.
    pub(super) fn forms<S: Oscillation<T>>(&self, first: &Ends<S>, second: &Ends<S>) -> [S; 2] {
        let Products { deflection, rotation, moment, shear, slope } = self.products(first, second);
        let beam = &self.parameters;
        let mass = deflection * beam.mass_per_length + rotation * beam.rotary_inertia;
        let bending = moment * (T::one() / beam.bending_stiffness) + shear * beam.shear_flexibility;
        [mass, bending + slope * beam.tension() + deflection * beam.foundation_stiffness]
    }

    /// `∂L/∂l = -½ (M²/EI + f σ Q² - 2σ Q Θ - g Θ² + h Y²)`, which is constant along the beam, at the end where its terms are smaller, since
    /// they cancel where waves decay.
    fn flow<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        let beam = &self.parameters;
        let sigma = self.constants.sigma;
        let square = ends.x.lambda_squared();
        let g = square * beam.rotary_inertia + S::from_parameter(sigma * beam.tension());
        let h = -(square * beam.mass_per_length) - S::from_parameter(beam.foundation_stiffness);
        let at_end = |state: &State<S>| {
            [
                -half(state.m * state.m) * (T::one() / beam.bending_stiffness),
                -half(state.q * state.q) * (sigma * beam.shear_flexibility),
                state.q * state.theta * sigma,
                half(g * state.theta * state.theta),
                -half(h * state.y * state.y),
            ]
        };
        let [input, output] = [at_end(&ends.input), at_end(&ends.output)];
        let size = |parts: &[S; 5]| parts.iter().map(|part| part.size()).sum::<f64>();
        let parts = if size(&input) < size(&output) { input } else { output };
        parts.into_iter().fold(S::zero(), |sum, part| sum + part)
    }
}

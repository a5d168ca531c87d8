//! The constants of a general beam in units of its length and its bending stiffness.

use crate::elements::general_beam::parameters::BeamParameters;
use crate::elements::general_beam::wave_pair::WavePair;
use crate::number::{Parameter, Scalar, Size, Truth};

/// What the equations of a beam are made of, in units of l and EI: Y in l, M in EI/l, Q in EI/l².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Constants<T> {
    /// `σ = 1/(1 + T f)`.
    pub(crate) sigma: T,
    /// `τ = f σ EI/l²`.
    pub(crate) tau: T,
    /// `σ T l²/EI`, what g is at rest.
    pub(crate) tension: T,
    /// `r l²/EI`, which λ² multiplies in g.
    pub(crate) rotary: T,
    /// `m l⁴/EI`.
    pub(crate) mass: T,
    /// `k l⁴/EI`.
    pub(crate) foundation: T,
}

/// The constants of the equations at a frequency.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SectionAt<S> {
    pub(crate) sigma: S,
    pub(crate) tau: S,
    /// `g = σ T + r λ²`.
    pub(crate) g: S,
    /// `h = -m λ² - k`.
    pub(crate) h: S,
    /// `σ² + τ g`, negative above the frequency of thickness shear.
    pub(crate) cut: S,
    pub(crate) waves: WavePair<S>,
}

impl<S: Scalar> Constants<S> {
    /// The constants of a beam.
    pub(crate) fn of(beam: BeamParameters<S>) -> Self {
        let BeamParameters { length, bending_stiffness, mass_per_length, shear_flexibility, .. } = beam;
        let tension = beam.axial_force + beam.foundation_shear_stiffness;
        let square = length * length;
        let scale = square / bending_stiffness;
        let sigma = S::one() / (S::one() + tension * shear_flexibility);
        Constants {
            sigma,
            tau: sigma * shear_flexibility / scale,
            tension: sigma * tension * scale,
            rotary: beam.rotary_inertia * scale,
            mass: mass_per_length * scale * square,
            foundation: beam.foundation_stiffness * scale * square,
        }
    }

    /// The constants with a moment against rotations at a frequency, in the units of g.
    #[inline]
    pub(crate) fn with_moment(self, moment: S) -> Self {
        Constants { tension: self.tension + moment, ..self }
    }

    /// The constants of the equations at λ².
    #[inline]
    pub(crate) fn at(&self, lambda_squared: S) -> SectionAt<S> {
        let Constants { sigma, tau, tension, rotary, mass, foundation } = *self;
        let g = tension + rotary * lambda_squared;
        let h = -(mass * lambda_squared + foundation);
        SectionAt::new([sigma, tau, g, h])
    }
}

impl<S: Scalar> SectionAt<S> {
    /// The constants for σ, τ, g and h.
    ///
    /// `δ = (g + τh)² + 4hσ²` is `s² - 4d` without cancellation.
    #[inline]
    fn new([sigma, tau, g, h]: [S; 4]) -> Self {
        let square = sigma * sigma;
        let cut = square + tau * g;
        let product = tau * h;
        let sum = g + product;
        let fourfold = (h * square).times_power_of_two(2);
        let waves = WavePair { sum: g - product, product: -(h * cut), square: sum * sum + fourfold };
        SectionAt { sigma, tau, g, h, cut, waves }
    }
}

/// Size up to which constants may go, so that their squares are in the range of the type.
const LARGEST: f64 = 1e100;

impl<T: Parameter> Constants<T> {
    /// The constants as numbers of another type.
    #[inline]
    pub(crate) fn map<S>(self, to: impl Fn(T) -> S) -> Constants<S> {
        let Constants { sigma, tau, tension, rotary, mass, foundation } = self;
        Constants {
            sigma: to(sigma),
            tau: to(tau),
            tension: to(tension),
            rotary: to(rotary),
            mass: to(mass),
            foundation: to(foundation),
        }
    }

    /// The parameter of a beam of a shear stiffness whose constant is beyond the range, with its value.
    pub(crate) fn out_of_range(&self, beam: &BeamParameters<T>, shear_stiffness: T) -> Option<(&'static str, f64)> {
        let Constants { sigma, tau, tension, rotary, mass, foundation } = *self;
        let origins = [
            (sigma + tau, "shear_stiffness", shear_stiffness),
            (tension, "axial_force", beam.axial_force),
            (rotary, "rotary_inertia", beam.rotary_inertia),
            (mass, "mass_per_length", beam.mass_per_length),
            (foundation, "foundation_stiffness", beam.foundation_stiffness),
        ];
        let is_beyond = |constant: T| !constant.size().is_below(T::Size::of(LARGEST)).all();
        let found = origins.into_iter().find(|(constant, ..)| is_beyond(*constant));
        found.map(|(_, name, value)| (name, value.to_f64()))
    }
}

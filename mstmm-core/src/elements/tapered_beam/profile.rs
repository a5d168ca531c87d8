//! The section of a tapered beam along it, at a frequency.

use crate::elements::tapered_beam::TaperedBeam;
use crate::number::{Parameter, Scalar};
use num_traits::Zero;

/// A number that varies evenly along the beam.
#[derive(Clone, Copy, Debug)]
pub(super) struct Even<S> {
    pub(super) start: S,
    /// Its change over the whole beam.
    pub(super) change: S,
}

impl<S: Scalar> Even<S> {
    /// The number at a share of the length.
    pub(super) fn at(&self, share: f64) -> S {
        self.start + self.change * S::from_f64(share)
    }
}

/// A beam along which shares of the length are counted from one of its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile<S> {
    pub(super) length: S,
    /// Bending stiffness, mass per length and rotary inertia where width and height are 1.
    pub(super) stiffness: S,
    pub(super) mass: S,
    pub(super) rotary: S,
    pub(super) width: Even<S>,
    pub(super) height: Even<S>,
    /// Position from the axis of rotation.
    pub(super) radius: Even<S>,
    pub(super) speed_squared: S,
    /// Axial force at the beam's output end.
    pub(super) force: S,
    /// Axial load per length, towards the output end.
    pub(super) load: S,
    pub(super) lambda_squared: S,
    /// `λ² - Ω² sin² ψ`, by which a mass holds against deflections.
    pub(super) of_mass: S,
    /// Stiffness of the foundation.
    pub(super) foundation: S,
    /// Share of the length at which the beam's output end is: 1, or 0 where shares are counted from there.
    pub(super) outer: f64,
}

impl<S: Scalar> Profile<S> {
    pub(super) fn of(beam: TaperedBeam<S>, lambda_squared: S, is_reversed: bool) -> Self {
        let even = |start: S, end: S, change: S| {
            if is_reversed { Even { start: end, change: -change } } else { Even { start, change } }
        };
        let one = S::one();
        let speed_squared = beam.rotation_speed * beam.rotation_speed;
        let (sin, _) = beam.setting_angle.sin_cos();
        Profile {
            length: beam.length,
            stiffness: beam.bending_stiffness,
            mass: beam.mass_per_length,
            rotary: beam.rotary_inertia,
            width: even(one, one - beam.width_taper, -beam.width_taper),
            height: even(one, one - beam.height_taper, -beam.height_taper),
            radius: even(beam.hub_radius, beam.hub_radius + beam.length, beam.length),
            speed_squared,
            force: beam.axial_force,
            load: beam.axial_load,
            lambda_squared,
            of_mass: lambda_squared - speed_squared * sin * sin,
            foundation: beam.foundation_stiffness,
            outer: if is_reversed { 0.0 } else { 1.0 },
        }
    }

    /// EI at a share of the length.
    pub(super) fn stiffness_at(&self, share: f64) -> S {
        self.stiffness * self.shape_at(share)
    }

    /// The mass per length.
    pub(super) fn mass_at(&self, share: f64) -> S {
        self.mass * self.width.at(share) * self.height.at(share)
    }

    /// What holds against deflections, `m (λ² - Ω² sin² ψ) + k`.
    pub(super) fn hold_at(&self, share: f64) -> S {
        self.mass_at(share) * self.of_mass + self.foundation
    }

    /// The rotary inertia per length.
    pub(super) fn rotary_at(&self, share: f64) -> S {
        self.rotary * self.shape_at(share)
    }

    /// `b h³`
    pub(super) fn shape_at(&self, share: f64) -> S {
        let height = self.height.at(share);
        self.width.at(share) * height * height * height
    }

    /// The axial force.
    pub(super) fn force_at(&self, share: f64) -> S {
        let pull = self.speed_squared * self.up_to_end(share, |at| self.mass_at(at) * self.radius.at(at));
        self.force + self.load * self.length * self.rest_at(share) + pull
    }

    /// The share of the length from a share up to the output end.
    pub(super) fn rest_at(&self, share: f64) -> S {
        S::from_f64(Parameter::abs(self.outer - share))
    }

    /// The integral over x of a polynomial of degree 3, from a share of the length to the output end, by Simpson's rule, which is exact.
    pub(super) fn up_to_end(&self, share: f64, at: impl Fn(f64) -> S) -> S {
        if share == self.outer {
            return S::zero();
        }
        let middle = at(0.5 * (share + self.outer));
        let sum = at(share) + S::from_f64(4.0) * middle + at(self.outer);
        self.length * self.rest_at(share) * sum / S::from_f64(6.0)
    }
}

impl Profile<f64> {
    /// A bound of the size of `m (λ² - Ω² sin² ψ) + k`, given those of m and of λ².
    pub(super) fn most_hold(&self, mass: f64) -> f64 {
        mass * (self.lambda_squared + self.speed_squared) + Parameter::abs(self.foundation)
    }

    /// The phase of bending waves along the whole beam, `∫ (m λ²/EI)^¼ dx`, given the size of λ².
    pub(super) fn phase(&self) -> f64 {
        let [first, last] = [0.0, 1.0].map(|end| Scalar::sqrt(self.height.at(end)));
        let square = Scalar::sqrt(self.mass * self.lambda_squared / self.stiffness);
        let phase = self.length * Scalar::sqrt(square) * 2.0 / (first + last);
        if self.lambda_squared.is_zero() { 0.0 } else { phase }
    }
}

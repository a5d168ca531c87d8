//! The receptances of a beam on two supports with `l = EI = m = 1`: static ones of beam theory, the rest as a sum over sines.

use std::f64::consts::PI;

/// A place, and what is asked for or acts there.
#[derive(Clone, Copy, Debug)]
pub(crate) enum At {
    /// Deflection or force.
    Deflection(f64),
    /// Rotation or moment.
    Rotation(f64),
}

use At::{Deflection, Rotation};

impl At {
    fn of_sine(self, wave: f64) -> f64 {
        match self {
            Deflection(x) => (wave * x).sin(),
            Rotation(x) => wave * (wave * x).cos(),
        }
    }
}

/// Static deflection or rotation due to a force or a moment of 1.
fn at_rest(load: At, place: At) -> f64 {
    match (load, place) {
        (Deflection(a), Deflection(x)) if x > a => at_rest(place, load),
        (Deflection(a), Deflection(x)) => (1.0 - a) * x * (1.0 - (1.0 - a) * (1.0 - a) - x * x) / 6.0,
        (Deflection(a), Rotation(x)) if x > a => a * (3.0 * (1.0 - x) * (1.0 - x) - 1.0 + a * a) / 6.0,
        (Deflection(a), Rotation(x)) => (1.0 - a) * (1.0 - (1.0 - a) * (1.0 - a) - 3.0 * x * x) / 6.0,
        (Rotation(_), Deflection(_)) => at_rest(place, load),
        (Rotation(a), Rotation(x)) if x > a => at_rest(place, load),
        (Rotation(a), Rotation(x)) => (3.0 * x * x + 3.0 * (1.0 - a) * (1.0 - a) - 1.0) / 6.0,
    }
}

/// The response at a place to a harmonic load of 1: `Σ 2 φ φ/(κ⁴ - Ω²)`, of which the static part is known.
pub(crate) fn receptance(load: At, place: At, omega: f64) -> f64 {
    let square = omega * omega;
    let term = |n: u32| {
        let wave = f64::from(n) * PI;
        let stiffness = wave.powi(4);
        2.0 * load.of_sine(wave) * place.of_sine(wave) * square / (stiffness * (stiffness - square))
    };
    at_rest(load, place) + (1..=300).rev().map(term).sum::<f64>()
}

//! Responses in time against responses at a frequency, which know nothing of modes.

use super::assert_close;
use super::histories::integral;
use crate::support::models::{DampedOscillator, damped_oscillator};
use mstmm::prelude::*;

const MODES: usize = 24;

/// The Laplace transform of the impulse response of section 4.5 is its frequency response at `λ = s`.
///
/// What the modes that are left out would add at s, less what they would add at 0, falls with the eighth power of their number:
/// `Σ φ² s (s + c φ²)/ω⁴`, where `c φ²` is the decay that the damper gives them. On a beam `φ² < 4/(m l)`, and
/// `ω > π² (k - 2)² sqrt(EI/m)/l²`, as springs only raise ω and the oscillator adds one pair or two real eigenvalues.
#[test]
fn the_laplace_transform_is_the_frequency_response() {
    let model = damped_oscillator();
    let system = model.build().unwrap();
    let point = DampedOscillator::conn_5;
    let roots = system.first_eigenvalues::<MODES>().unwrap();
    let highest = roots[roots.len() - 1].lambda.im;
    let left_out: f64 = (MODES - 2..10_000).map(|k| (k as f64).powi(-8)).sum();
    let square = 4.0 / (model.mass_per_length * model.length);
    let unit = std::f64::consts::PI.powi(2) * (model.bending_stiffness / model.mass_per_length).sqrt();
    for entry in [point.deflection(), DampedOscillator::mass_7.output().deflection()] {
        let response = system.modal_response::<MODES, _>(&roots, point.force(), entry).unwrap();
        let exact = system.frequency_response(point.force(), entry).unwrap();
        let at = |s: f64| exact.at(Complex::new(s, 0.0)).unwrap();
        for s in [200.0, 900.0] {
            let end = 40.0 / s;
            let panels = (end * highest) as usize;
            let transform = integral(0.0, end, panels, |t| (-s * t).exp() * response.to_impulse(t));
            let of_modes = response.static_value().unwrap() - response.to_step(0.0);
            let difference = transform - of_modes;
            let expected = at(s).re - at(0.0).re;
            let truncation = square * s * (s + model.damping * square) / unit.powi(4) * left_out;
            let limit = truncation + 1e-12 * expected.abs();
            assert!((difference - expected).abs() < limit);
        }
    }
}

/// The motion under a constant load comes to rest where the spring holds it.
#[test]
fn a_step_comes_to_rest() {
    let system = super::Damped { k: 5.0, c: 0.4, m: 0.75 }.build().unwrap();
    let tip = super::Damped::mass_2.output();
    let roots = system.first_eigenvalues::<1>().unwrap();
    let response = system.modal_response::<1, _>(&roots, tip.force(), tip.deflection()).unwrap();
    assert_close(response.to_step(200.0), 0.2, 0.2, 16.0);
}

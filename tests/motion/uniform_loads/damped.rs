//! Uniform loads on beams of damped materials: those of the undamped beam at another frequency.

use mstmm::motion::Load;
use mstmm::prelude::*;

system! {
    struct Damped { ei: f64, m: f64, eta: f64, time: f64 }
    fixed -> beam 1 { length: 1.3, bending_stiffness: ei, mass_per_length: m, loss_factor: eta, kelvin_voigt_time: time } -> free
}

system! {
    struct Plain { ei: f64, m: f64 }
    fixed -> beam 1 { length: 1.3, bending_stiffness: ei, mass_per_length: m } -> free
}

/// Oracle: with `EI e` for EI the motion at λ is that of the beam without damping at `λ/√e`, over e.
#[test]
fn a_damped_cantilever_is_the_plain_one_at_another_frequency() {
    let (ei, m, eta, time) = (7.0, 1.9, 0.2, 3e-3);
    let (damped, plain) = (Damped { ei, m, eta, time }.build().unwrap(), Plain { ei, m }.build().unwrap());
    let tip = Damped::beam_1.output().deflection();
    let loaded = damped.frequency_response(Damped::beam_1.uniform_load(), tip).unwrap();
    let weighed = damped.frequency_response(Load::self_weight(), tip).unwrap();
    let same = plain.frequency_response(Plain::beam_1.uniform_load(), Plain::beam_1.output().deflection()).unwrap();
    for lambda in [(0.0, 0.1), (0.0, 4.0), (-0.3, 11.0), (0.0, 300.0), (-1.0, 6e3)] {
        let lambda = Complex::new(lambda.0, lambda.1);
        let factor = Complex::new(1.0, eta) * (1.0 + time * lambda);
        let expected = same.at(lambda / factor.sqrt()).unwrap() / factor;
        let (found, weight) = (loaded.at(lambda).unwrap(), weighed.at(lambda).unwrap());
        assert!((found - expected).norm() < 1e-12 * expected.norm(), "at {lambda}: {found}, not {expected}");
        assert!((weight - expected * m).norm() < 1e-12 * (expected * m).norm(), "weight at {lambda}: {weight}");
    }
    // q l⁴/(8 EI (1 + iη)) at rest
    let rest = loaded.at(Complex::new(0.0, 0.0)).unwrap();
    assert!((rest * Complex::new(1.0, eta) * 8.0 * ei / 1.3_f64.powi(4) - 1.0).norm() < 1e-13, "{rest}");
}

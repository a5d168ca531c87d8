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

system! {
    struct DampedRod { ea: f64, m: f64, eta: f64, time: f64, medium: f64 }
    fixed -> rod 1 { length: 1.3, axial_stiffness: ea, mass_per_length: m, loss_factor: eta, kelvin_voigt_time: time, external_damping: medium }
          -> mass 2 { mass: 0.4 } -> free
}

system! {
    struct PlainRod { ea: f64, m: f64, mass: f64 }
    fixed -> rod 1 { length: 1.3, axial_stiffness: ea, mass_per_length: m } -> mass 2 { mass } -> free
}

/// The medium damps the rod as a part of its mass that grows with 1/λ, and so does a mass that grows so at its end.
#[test]
fn a_damped_rod_is_the_plain_one_at_another_frequency() {
    let (ea, m, eta, time) = (7.0, 1.9, 0.2, 3e-3);
    for medium in [0.0, 0.8] {
        let damped = DampedRod { ea, m, eta, time, medium }.build().unwrap();
        let tip = DampedRod::rod_1.output().deflection();
        let loaded = damped.frequency_response(DampedRod::rod_1.uniform_load(), tip).unwrap();
        let weighed = damped.frequency_response(Load::self_weight(), tip).unwrap();
        for omega in [0.1, 4.0, 11.0, 300.0, 6e3] {
            let lambda = Complex::new(-0.01 * omega, omega);
            let factor = Complex::new(1.0, eta) * (1.0 + time * lambda);
            // closed form: u = (q/D) (1 - cosh s(l-x)/cosh sl ..) of a rod with a mass at its end
            let density = m * lambda * lambda + medium * lambda;
            let stiffness = ea * factor;
            let rate = (density / stiffness).sqrt();
            let z = rate * 1.3;
            let inertia = 0.4 * lambda * lambda;
            // u = a sinh(s x) + (q/D) (1 - cosh s x), with H u'(l) = F - M λ² u(l)
            let end = |force: f64| {
                let (sinh, cosh) = (z.sinh(), z.cosh());
                let slope = stiffness * rate;
                let a = (force + slope * sinh / density - inertia * (1.0 - cosh) / density)
                    / (slope * cosh + inertia * sinh);
                a * sinh + (1.0 - cosh) / density
            };
            if z.re.abs() < 20.0 {
                let (found, expected) = (loaded.at(lambda).unwrap(), end(0.0));
                assert!((found - expected).norm() < 1e-10 * expected.norm(), "at {lambda}: {found}, not {expected}");
                // the weight of the rod is m times the load, with that of the mass
                let (found, expected) = (weighed.at(lambda).unwrap(), end(0.4 / m) * m);
                assert!(
                    (found - expected).norm() < 1e-10 * expected.norm(),
                    "weight at {lambda}: {found}, not {expected}"
                );
            }
        }
    }
    let plain = PlainRod { ea, m, mass: 0.4 }.build().unwrap();
    let undamped = DampedRod { ea, m, eta: 0.0, time: 0.0, medium: 0.0 }.build().unwrap();
    let at = |omega: f64| {
        let one = undamped.frequency_response(Load::self_weight(), DampedRod::rod_1.output().deflection()).unwrap();
        let other = plain.frequency_response(Load::self_weight(), PlainRod::rod_1.output().deflection()).unwrap();
        (one.at(Complex::new(0.0, omega)).unwrap().re, other.at(omega).unwrap())
    };
    for omega in [0.0, 0.3, 2.0, 40.0] {
        let (one, other) = at(omega);
        assert!((one - other).abs() < 1e-12 * other.abs());
    }
}

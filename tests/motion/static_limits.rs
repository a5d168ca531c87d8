//! Static limits of responses, beside what nothing holds as well.
#![allow(missing_docs, reason = "models of a test")]

use mstmm::motion::MotionError;
use mstmm::number::{DoubleDouble, Real};
use mstmm::prelude::*;

system! {
    /// A mass on a spring, and one that a damper alone ties to it.
    struct Behind { k: f64, c: f64, m: f64, n: f64 }
    free -> mass 1 { mass: n } -> damper 2 { damping: c } -> mass 3 { mass: m } -> spring 4 { stiffness: k } -> fixed;
}

system! {
    /// A beam on a hinge, which a spring holds: the beam may turn about it.
    struct Hinged { k: f64, l: f64, ei: f64, m: f64 }
    free -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2 -> spring 3 { stiffness: k } -> fixed;
}

const AT_REST: MotionError = MotionError::Resonance { frequency: 0.0 };

/// `|actual - expected| <= factor · eps · |expected|`.
#[track_caller]
fn assert_close<T: Real>(actual: T, expected: f64, factor: f64) {
    let error = (actual - T::from_f64(expected)).size() / expected.abs();
    assert!(error <= factor * T::EPSILON, "{actual:?} is not {expected}: {error:e}");
}

/// Closed form: at rest the damper carries nothing, and the spring holds the mass. Of the numbers all digits are in both bases.
#[test]
fn beside_what_only_a_damper_holds() {
    fn check<T: Real>(exponents: [i32; 4], factor: f64) {
        let [k, c, m, n] = exponents.map(|exponent| 2f64.powi(exponent));
        let system = Behind { k, c, m, n }.build_as::<T>().unwrap();
        let (held, loose) = (Behind::mass_3.output(), Behind::mass_1.output());
        let rest = Complex::new(T::zero(), T::zero());
        let at = |load, entry| system.frequency_response(load, entry).unwrap().at(rest);
        let value = at(held.force(), held.deflection()).unwrap_or_else(|error| panic!("{exponents:?}: {error}"));
        assert_close(value.re, 1.0 / k, factor);
        // without a force on it the loose mass creeps after the other
        assert_close(at(held.force(), loose.deflection()).unwrap().re, 1.0 / k, factor);
        assert_eq!(at(loose.force(), loose.deflection()).unwrap_err(), AT_REST, "{exponents:?}");
    }
    check::<f64>([2, 1, 0, 1], 8.0);
    check::<f32>([2, 1, 0, 1], 8.0);
    check::<DoubleDouble>([2, 1, 0, 1], 8.0);
    for exponents in (0..625).map(|n| [n % 5, n / 5 % 5, n / 25 % 5, n / 125].map(|e| 10 * (e - 2))) {
        check::<f64>(exponents, 64.0);
    }
}

/// Closed form: the spring holds the hinge, and the beam, a rod without a support of its own, turns about its centre of
/// oscillation, at two thirds of its length, as it does under an ever slower load.
#[test]
fn beside_a_rigid_body_at_rest() {
    let (k, l) = (4.0, 1.5);
    fn check<T: Real>(system: &Hinged, factor: f64) {
        let Hinged { k, l, .. } = *system;
        let system = Hinged { ..*system }.build_as::<T>().unwrap();
        let (hinge, end) = (Hinged::conn_2, Hinged::beam_1.input());
        let response = |load, entry| system.frequency_response(load, entry).unwrap();
        for (entry, expected) in [
            (hinge.deflection(), 1.0 / k),
            (end.deflection(), -0.5 / k),
            (end.rotation(), 1.5 / (l * k)),
            (Hinged::beam_1.output().rotation(), 1.5 / (l * k)),
            (Hinged::spring_3.output().shear(), 1.0),
        ] {
            let response = response(hinge.force(), entry);
            assert_close(response.at(T::zero()).unwrap(), expected, factor);
            assert_close(response.at(Complex::new(T::zero(), T::zero())).unwrap().re, expected, factor);
        }
        assert_eq!(response(end.force(), end.deflection()).at(T::zero()).unwrap_err(), AT_REST);
        assert_eq!(response(hinge.torque(), end.rotation()).at(T::zero()).unwrap_err(), AT_REST);
    }
    let system = Hinged { k, l, ei: 2.0, m: 0.75 };
    check::<f64>(&system, 64.0);
    check::<f32>(&system, 64.0);
    check::<DoubleDouble>(&system, 64.0);
}

/// On a grid, in blocks, rest is what it is alone.
#[test]
fn on_a_grid() {
    let system = Hinged { k: 4.0, l: 1.5, ei: 2.0, m: 0.75 }.build().unwrap();
    let response = system.frequency_response(Hinged::conn_2.force(), Hinged::beam_1.input().rotation()).unwrap();
    let grid: Vec<f64> = (0..40).map(f64::from).collect();
    let mut values = vec![f64::NAN; grid.len()];
    response.on(&grid, &mut values).unwrap();
    for (x, value) in grid.iter().zip(values) {
        assert_eq!(value.to_bits(), response.at(*x).unwrap().to_bits(), "{x}");
    }
    let moves_off = system.frequency_response(Hinged::beam_1.input().force(), Hinged::conn_2.deflection()).unwrap();
    let mut values = vec![0.0; grid.len()];
    assert!(moves_off.at(0.0).is_ok() && moves_off.on(&grid, &mut values).is_ok());
    let moves_off =
        system.frequency_response(Hinged::beam_1.input().force(), Hinged::beam_1.input().deflection()).unwrap();
    assert_eq!(moves_off.on(&grid, &mut values), Err(AT_REST));
}

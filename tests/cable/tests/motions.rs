//! Shapes, responses and sensitivities of a string, against the textbook.

use core::f64::consts::PI;
use mstmm::motion::{DrawnPart, Extent};
use mstmm::prelude::*;

system! {
    struct TautString { length: f64, tension: f64, mass_per_length: f64 }
    fixed -> cable::Cable 1 { length, tension, mass_per_length } -> fixed;
}

system! {
    struct Halves { half: f64, tension: f64, mass_per_length: f64 }
    fixed -> cable::Cable first { length: half, tension, mass_per_length }
          -> cable::Cable second { length: half, tension, mass_per_length } -> fixed;
}

const STRING: TautString = TautString { length: 2.0, tension: 50.0, mass_per_length: 0.02 };

/// `sqrt(2/(m l)) sin(nπx/l)`, of modal mass 1.
#[test]
fn shapes_are_sines() {
    let system = STRING.build().unwrap();
    let amplitude = (2.0 / (STRING.mass_per_length * STRING.length)).sqrt();
    for (n, root) in (1..).zip(&system.first_frequencies::<100>().unwrap()) {
        let shape = system.mode_shape(root).unwrap();
        assert_eq!(shape.nodes(TautString::Cable_1), n - 1);
        let slope = shape.state(TautString::Cable_1.input()).q;
        for share in [0.1, 0.37, 0.5, 0.93] {
            let sine = -amplitude * slope.signum() * (n as f64 * PI * share).sin();
            let y = shape.along(TautString::Cable_1, share * STRING.length).unwrap().y;
            // the phase carries the rounding of n waves
            assert!((y - sine).abs() < 1e-14 * n as f64 * amplitude, "{n} at {share}: {y} is not {sine}");
        }
    }
}

/// `ω = (nπ/l) sqrt(H/m)`
#[test]
fn sensitivities_are_those_of_the_formula() {
    let system = STRING.build().unwrap();
    for root in &system.first_frequencies::<20>().unwrap() {
        let sensitivities = system.sensitivity(root).unwrap();
        let expected = [
            ("length", -root.omega / STRING.length),
            ("tension", root.omega / (2.0 * STRING.tension)),
            ("mass_per_length", -root.omega / (2.0 * STRING.mass_per_length)),
        ];
        for (name, expected) in expected {
            let value = sensitivities.get(name).unwrap();
            assert!((value / expected - 1.0).abs() < 1e-12, "{name}: {value} is not {expected}");
        }
    }
}

/// Under a force at its middle a string of length l = 2 a rises by `sin(ka)²/(H k sin(2ka))`, at rest by `a/(2H)`.
#[test]
fn responses_are_those_of_the_formula() {
    let (half, tension, mass_per_length) = (1.3, 50.0, 0.02);
    let system = Halves { half, tension, mass_per_length }.build().unwrap();
    let middle = Halves::Cable_first.output();
    let response = system.frequency_response(middle.force(), middle.deflection()).unwrap();
    assert!((response.at(0.0).unwrap() / (half / (2.0 * tension)) - 1.0).abs() < 1e-14);
    for omega in [1.0, 50.0, 333.0, 2500.0_f64] {
        let k = omega * (mass_per_length / tension).sqrt();
        let expected = (k * half).sin().powi(2) / (tension * k * (2.0 * k * half).sin());
        assert!((response.at(omega).unwrap() / expected - 1.0).abs() < 1e-12);
    }
}

/// Drawings know it by the name of its type, with the length that it tells.
#[test]
fn a_cable_is_in_the_sketch_of_its_model() {
    let system = STRING.build().unwrap();
    let parts: Vec<_> = system.sketch().steps().map(|step| (step.name.to_string(), step.part)).collect();
    let cable = DrawnPart::Element { kind: "Cable", extent: Extent::along(2.0) };
    assert_eq!(parts[1], ("Cable 1".to_owned(), cable));
}

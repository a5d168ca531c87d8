//! The frequencies, shapes and receptances of tests/data/space.json.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use crate::cases::{cases, list, text};
use mstmm::frame::{InFrame, Point, Space};
use mstmm::motion::{PlaneEntry, PlaneLoad};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use serde_json::Value;

/// Rounding of a frequency beside its condition, in units of 2^-52.
const ROUNDINGS: f64 = 4.0;

/// Oracle: dynamic stiffness in 77 digits with counts in ball arithmetic, checked by polynomials.
#[test]
fn all_frequencies_are_proven_and_exact() {
    let mut compared = 0;
    for case in cases().into_iter().filter(|case| case.wanted["lambda"].is_null()) {
        let structure = case.frame.build().unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let exact = case.frequencies();
        let count = case.wanted["omega"].as_array().unwrap().len();
        let found = structure.frequencies(count).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        for exact in exact.iter().filter(|exact| exact.mode <= count as u64) {
            // roots that rounding tells apart may be one entry, and one root is never two
            let last = exact.mode + exact.multiplicity - 1;
            let holds = |own: &&NaturalFrequency<f64>| own.index <= exact.mode && last < own.index + own.multiplicity;
            let own = found.iter().find(holds).unwrap_or_else(|| panic!("{} {}", case.name, exact.mode));
            let error = (DoubleDouble::from(own.omega) - exact.omega).to_f64().abs();
            let limit = exact
                .condition
                .map_or(1e-3, |condition| ROUNDINGS * f64::EPSILON * condition.max(1.0) * exact.omega.to_f64());
            assert!(error <= limit && own.is_proven, "{} {}: {error:e} of {limit:e}, {own:?}", case.name, exact.mode);
            compared += 1;
        }
    }
    assert!(compared >= 150, "{compared}");
}

/// The modes far above the others.
#[test]
fn modes_far_above_are_exact() {
    let mut compared = 0;
    for case in cases() {
        let count = case.wanted["omega"].as_array().map_or(0, Vec::len);
        let Some(exact) = case.frequencies().into_iter().find(|exact| exact.mode > count as u64) else { continue };
        let (structure, omega) = (case.frame.build().unwrap(), exact.omega.to_f64());
        let found = structure.frequencies_in(0.999 * omega..=1.001 * omega).unwrap();
        let own = found.iter().find(|own| own.index == exact.mode).unwrap();
        let error = (DoubleDouble::from(own.omega) - exact.omega).to_f64().abs();
        let limit = ROUNDINGS * f64::EPSILON * exact.condition.unwrap() * omega;
        assert!(error <= limit && own.is_proven, "{} {}: {error:e} of {limit:e}", case.name, exact.mode);
        compared += 1;
    }
    assert_eq!(compared, 3);
}

/// The places of words among the displacements of a point.
const WORDS: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];

/// The displacements of a point, in the order of the words.
fn entries(point: Point<Space>) -> [PlaneEntry<InFrame>; 6] {
    [
        point.displacement_x(),
        point.displacement_y(),
        point.displacement_z(),
        point.rotation_x(),
        point.rotation_y(),
        point.rotation_z(),
    ]
}

/// The loads on a point, in the order of the words.
fn loads(point: Point<Space>) -> [PlaneLoad<InFrame>; 6] {
    [point.force_x(), point.force_y(), point.force_z(), point.torque_x(), point.torque_y(), point.torque_z()]
}

fn numbers(value: &Value) -> Vec<f64> {
    list(value).iter().map(|number| text(number).parse().unwrap()).collect()
}

/// Oracle: as for frequencies. With damping a response is complex, at `λ = iω`.
#[test]
fn receptances_are_exact() {
    let mut compared = 0;
    for case in cases() {
        let is_damped = !case.wanted["lambda"].is_null();
        let place = |value: &Value| {
            let axis = WORDS.iter().position(|word| *word == text(&value[1])).unwrap();
            (case.points[text(&value[0])], axis)
        };
        for receptance in list(&case.wanted["receptance"]) {
            let (loaded, axis) = place(&receptance["load"]);
            let load = loads(loaded)[axis];
            for row in list(&receptance["rows"]) {
                let omega = row["omega"].as_f64().unwrap();
                let exact: Vec<_> = list(&row["H"]).iter().map(numbers).collect();
                let largest = exact.iter().map(|value| value[0].hypot(value[1])).fold(0.0, f64::max);
                for (at, exact) in list(&receptance["at"]).iter().zip(exact) {
                    let (read, axis) = place(at);
                    let entry = entries(read)[axis];
                    let value = if is_damped {
                        let structure = case.frame.build_damped().unwrap();
                        structure.frequency_response(load, entry).unwrap().at(Complex::new(0.0, omega)).unwrap()
                    } else {
                        let structure = case.frame.build().unwrap();
                        Complex::new(structure.frequency_response(load, entry).unwrap().at(omega).unwrap(), 0.0)
                    };
                    let error = (value - Complex::new(exact[0], exact[1])).norm() / largest;
                    assert!(error <= 1e-13, "{} {omega} {at}: {error:e}", case.name);
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 31, "{compared}");
}

/// Oracle: as for frequencies. The sign of a shape is free.
#[test]
fn shapes_are_exact() {
    let mut compared = 0;
    for case in cases() {
        for shape in list(&case.wanted["shapes"]) {
            let structure = case.frame.build().unwrap();
            let mode = shape["mode"].as_u64().unwrap();
            let roots = structure.frequencies(mode as usize + 1).unwrap();
            let root = roots.iter().find(|root| root.index == mode).unwrap();
            let found = structure.mode_shape(root).unwrap();
            let of = |point: Point<Space>| entries(point).map(|entry| found.value(entry).unwrap_or_default());
            let all: Vec<_> = case
                .points
                .iter()
                .flat_map(|(name, point)| numbers(&shape["unit_modal_mass"][name]).into_iter().zip(of(*point)))
                .collect();
            let largest = all.iter().map(|(exact, _)| exact.abs()).fold(0.0, f64::max);
            let sign = all.iter().map(|(exact, own)| exact * own).sum::<f64>().signum();
            for (exact, own) in all {
                assert!((exact - sign * own).abs() <= 1e-14 * largest, "{} {mode}: {exact} {own}", case.name);
            }
            assert!((found.modal_mass() - 1.0).abs() < 1e-13);
            compared += 1;
        }
    }
    assert_eq!(compared, 3);
}

/// Oracle: contours of the determinant in 77 digits.
#[test]
fn eigenvalues_of_the_damped_tube_are_exact() {
    let case = cases().into_iter().find(|case| !case.wanted["lambda"].is_null()).unwrap();
    let structure = case.frame.build_damped().unwrap();
    let radius = case.wanted["radius"].as_f64().unwrap();
    let region = Region { re: -radius..=0.0, im: 1.0..=radius };
    let found = structure.eigenvalues_in(region).unwrap();
    let exact: Vec<_> = list(&case.wanted["lambda"]).iter().map(numbers).collect();
    for exact in &exact {
        let exact = Complex::new(exact[0], exact[1]);
        let nearest = found.iter().map(|own| (own.lambda - exact).norm()).fold(f64::INFINITY, f64::min);
        assert!(nearest <= 1e-13 * exact.norm(), "{exact}: {nearest:e}");
    }
    let within = found.iter().filter(|own| own.lambda.norm() < radius).count();
    assert_eq!(within, exact.len());
    assert!(found.iter().all(|own| own.is_proven), "{found:?}");
}

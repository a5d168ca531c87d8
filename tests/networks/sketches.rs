//! Sketches of located points against exact cases and against the same structures as lists.
#![expect(clippy::unwrap_used, clippy::panic, reason = "a structure that cannot be built fails the test")]

mod bad_numbers;
mod bars;
mod drawn;
pub(crate) mod frames;
mod general_beams;
mod hinges;
mod line;
mod lists;
mod overall;
mod run_time;
mod strings;
mod tapered;

use crate::checks::Found;
use crate::judgement::{judge_frequencies, judge_reference_cases};
use crate::reference_cases::exact_frequencies;
use frames::{HingedFrame, InclinedRoller, LFrame, NafemsCross, NafemsSquare, Portal, StringAndRod, ThreePorts};
use mstmm::prelude::*;
use mstmm::search::{NaturalFrequencies, Spectrum, Undamped};

/// The first frequencies.
pub(crate) fn first<Y: NaturalFrequencies<Parameter = f64> + Undamped>(system: &Y) -> Vec<Found> {
    let found = system.first_frequencies::<10>().unwrap();
    let entry = |root: &NaturalFrequency<f64>| Found {
        omega: root.omega,
        lower: root.lower,
        upper: root.upper,
        multiplicity: root.multiplicity,
    };
    found.iter().map(entry).collect()
}

/// The first frequencies as numbers, each as often as it is there.
fn frequencies<Y: NaturalFrequencies<Parameter = f64> + Undamped>(system: &Y) -> Vec<f64> {
    let often = |found: Found| (0..found.multiplicity).map(move |_| found.omega);
    first(system).into_iter().flat_map(often).collect()
}

/// The first eigenvalues.
fn eigenvalues<Y: Eigenvalues<Parameter = f64> + Spectrum>(system: &Y) -> Vec<Complex<f64>> {
    system.first_eigenvalues::<6>().unwrap().iter().map(|root| root.lambda).collect()
}

/// Frequencies agree up to a relative difference.
#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (one, other) in found.iter().zip(expected) {
        assert!((one - other).abs() <= tolerance * other, "{one} and {other}: {}", one / other - 1.0);
    }
}

/// The frequencies of the sketch of a case.
fn of_sketch(name: &str) -> Vec<Found> {
    match name {
        "nafems_fv1" => {
            let cross = NafemsCross { length: 5.0, ea: 3.125e9, ei: 4069010.4166666665, m: 125.0 };
            first(&cross.build().unwrap())
        }
        "nafems_fv3" => {
            let square = NafemsSquare { side: 10.0, ea: 1.25e10, ei: 65104166.666666664, m: 500.0 };
            first(&square.build().unwrap())
        }
        "l_frame" => first(&LFrame { height: 1.0, width: 1.5, ea: 1e6, ei: 100.0, m: 1.0 }.build().unwrap()),
        "portal" => first(&Portal { side: 2.0, ea: 4e8, ei: 1e6, m: 20.0 }.build().unwrap()),
        "hinged_frame" => first(&HingedFrame { height: 2.0, ea: 2e7, ei: 5000.0, m: 6.0 }.build().unwrap()),
        "inclined_roller" => first(&InclinedRoller { length: 2.0, ea: 3e6, ei: 500.0, m: 2.0 }.build().unwrap()),
        "body_three_ports" => first(&ThreePorts { ea: 1e6, ei: 150.0, m: 1.2, stiffness: 900.0 }.build().unwrap()),
        _ => panic!("no sketch of {name}"),
    }
}

#[test]
fn exact_reference_cases_lie_in_the_intervals_of_their_sketches() {
    judge_reference_cases(|case| Ok(of_sketch(case.name)));
}

/// A string that stretches moves across itself and along itself: its frequencies are those of both.
#[test]
fn a_string_and_a_rod_along_each_other_have_the_exact_frequencies_of_both() {
    let model = StringAndRod { left: 0.8, right: 1.2, tension: 100.0, ea: 1e4, m: 0.01, mass: 0.02 };
    let found = first(&model.build().unwrap());
    judge_frequencies("string_and_rod", &found, &exact_frequencies("string_and_rod"));
}

//! The response against that of a bare beam.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

#[path = "../../../tests/support/example.rs"]
pub mod example;
#[expect(dead_code, reason = "the example's main and its plot")]
#[path = "../frequency_response.rs"]
pub mod frequency_response;
#[path = "support/simple_beam.rs"]
mod simple_beam;

use example::{FOLDER, assert_close, printed, rows_of};
use mstmm::prelude::*;
use nalgebra::{Matrix3, Vector3};
use simple_beam::{At, receptance};
use std::path::Path;

/// Oracle: the response of a bare beam, on which the springs and the oscillator act as forces.
fn expected() -> impl Fn(f64) -> Complex<f64> {
    let model = frequency_response::steel_bar();
    let unit = (model.ei / model.m).sqrt();
    move |omega| {
        let omega = omega / unit;
        let places = [At::Deflection(0.2), At::Deflection(0.6), At::Rotation(0.75)];
        let (link, inertia) = (Complex::new(4.0, omega), Complex::from(-0.12 * omega * omega));
        let stiffness = [Complex::from(5.0), link * inertia / (link + inertia), Complex::from(10.0)];
        let matrix = Matrix3::from_fn(|row, column| {
            let own = f64::from(u8::from(row == column));
            receptance(places[column], places[row], omega) * stiffness[column] + own
        });
        let direct = Vector3::from(places.map(|place| Complex::from(receptance(places[0], place, omega))));
        matrix.lu().solve(&direct).unwrap()[0] / model.ei
    }
}

fn samples() -> Vec<(f64, Complex<f64>)> {
    frequency_response::receptance(&frequency_response::steel_bar().build().unwrap()).unwrap()
}

#[test]
fn the_frequency_response_is_that_of_a_bare_beam_with_springs() {
    let response = expected();
    for (omega, value) in samples() {
        let expected = response(omega);
        assert!((value - expected).norm() < 1e-9 * expected.norm(), "{omega}: {value} {expected}");
    }
}

/// Both files hold every sample, and the table its digits.
#[test]
fn the_response_is_written_for_other_programs() {
    let [uff, csv] = ["response.uff", "response.csv"].map(|name| Path::new(FOLDER).join(name).display().to_string());
    let samples = samples();
    let arguments = ["--uff", &uff, "--csv", &csv].map(str::to_owned);
    frequency_response::write(&samples, &arguments).unwrap();
    let [uff, csv] = [uff, csv].map(|file| std::fs::read_to_string(file).unwrap());
    // a head of thirteen lines and a mark at the end; a line of names
    assert_eq!((uff.lines().count(), csv.lines().count()), (samples.len() + 14, samples.len() + 1));
    let (response, row) = (expected(), csv.lines().nth(100).unwrap());
    let fields: Vec<f64> = row.split(',').map(|field| field.parse().unwrap()).collect();
    assert_close(fields[2], response(fields[1]).re, 1e-9);
    for wrong in [&["--uff"][..], &["--xls", "file"]] {
        let wrong: Vec<String> = wrong.iter().map(|word| (*word).to_owned()).collect();
        assert!(frequency_response::write(&samples, &wrong).is_err(), "{wrong:?}");
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn the_program_prints_the_resonances_and_draws_the_curve() {
    let (response, samples) = (expected(), samples());
    let text = printed("frequency_response");
    let rest = text.split(' ').find_map(|word| word.parse::<f64>().ok()).unwrap();
    assert_close(rest, response(0.0).re, 1e-6);
    let resonances = rows_of(&text, "resonance");
    assert_eq!(resonances.len(), 4);
    for row in resonances {
        let value = response(row[0]);
        assert_close(row[3], value.norm(), 1e-3);
        assert!((row[4] - value.arg().to_degrees()).abs() < 0.02, "{row:?} {value}");
        // beyond heavy damping the curve peaks at the resonance, and samples are close there
        if row[2] < 0.1 {
            let near = samples.iter().filter(|sample| (sample.0 - row[0]).abs() < row[2] * row[0]);
            let peak = near.map(|sample| sample.1.norm()).fold(0.0, f64::max);
            assert!(peak >= value.norm() * 0.999 && peak < value.norm() * 1.02, "{row:?} {peak:e}");
        }
    }
    let drawn = std::fs::read_to_string(Path::new(FOLDER).join("target/frequency_response.svg")).unwrap();
    assert!(drawn.starts_with("<svg") && drawn.trim_end().ends_with("</svg>"));
}

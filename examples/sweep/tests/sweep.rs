//! The file holds what the models give, in their order.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use indicatif::ProgressBar;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use std::f64::consts::PI;
use std::fs::File;
use std::path::Path;
use sweep::model::model;
use sweep::{Label, Shard, rows, table};

/// Parameters and frequencies of a model.
fn row(index: u64) -> [f64; 7] {
    let row = rows(&[model(index)]).pop().unwrap();
    [&row.parameters[..], &row.omegas.unwrap()].concat().try_into().unwrap()
}

/// The rows of a file, block after block.
fn rows_of(file: &Path) -> Vec<[f64; 7]> {
    let reader = SerializedFileReader::new(File::open(file).unwrap()).unwrap();
    let rows = reader.get_row_iter(None).unwrap().map(Result::unwrap);
    rows.map(|row| std::array::from_fn(|column| row.get_double(column).unwrap())).collect()
}

/// More than a block, and not a multiple of it.
#[test]
fn the_file_reads_back_as_the_models_in_their_order() {
    let (count, file) = (70_001, Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep.parquet"));
    let label = Label::new(count, 1);
    assert_eq!(table::write(&file, &label, Shard::WHOLE, model, &ProgressBar::hidden()).unwrap(), 0);
    let rows = rows_of(&file);
    assert_eq!(rows.len() as u64, count);
    for index in (0..count).step_by(997).chain([65_535, 65_536, 70_000]) {
        // a model beside others and one alone are searched in two ways
        for (found, alone) in rows[index as usize].iter().zip(row(index)) {
            assert!((found - alone).abs() <= 1e-14 * alone, "{index}: {found} and {alone}");
        }
    }
}

/// Oracle: the receptances of the bare beam, as sums over its sines.
#[test]
fn frequencies_are_those_of_a_bare_beam_with_a_spring_and_a_mass() {
    for index in [1, 17, 4711] {
        let [spring_at, mass_at, stiffness, mass, omegas @ ..] = row(index);
        for omega in omegas {
            let [below, above] =
                [1.0 - 1e-9, 1.0 + 1e-9].map(|factor| residual(factor * omega, [spring_at, mass_at, stiffness, mass]));
            assert!(below * above < 0.0, "{index} at {omega}: {below:e} {above:e}");
        }
    }
}

/// Changes its sign where the forces of spring and mass are those of the deflections that they cause.
fn residual(omega: f64, [spring_at, mass_at, stiffness, mass]: [f64; 4]) -> f64 {
    let receptance = |x: f64, y: f64| {
        let term = |n: u32| {
            let wave = f64::from(n) * PI;
            2.0 * (wave * x).sin() * (wave * y).sin() / (wave.powi(4) - omega * omega)
        };
        (1..=10_000).rev().map(term).sum::<f64>()
    };
    let [own, cross, at_mass] =
        [(spring_at, spring_at), (spring_at, mass_at), (mass_at, mass_at)].map(|(x, y)| receptance(x, y));
    let inertia = -mass * omega * omega;
    (1.0 + stiffness * own) * (1.0 + inertia * at_mass) - stiffness * inertia * cross * cross
}

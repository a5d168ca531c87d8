//! Laws of frames in space: a structure is the same wherever it stands, and a beam the same as its pieces.
#![expect(clippy::unwrap_used, clippy::panic, reason = "all structures are right")]

use crate::random::{Model, random_model, rotation, turned};
use mstmm::frame::{InFrame, Point, Space, Structure};
use mstmm::motion::{PlaneEntry, PlaneLoad};
use mstmm::prelude::*;
use mstmm::search::SearchError;
use std::ops::Range;

/// Frequencies of each structure that are compared.
const COUNT: usize = 8;

/// The first frequencies, each as often as it is one; all proven.
fn frequencies(model: &Model, seed: u64) -> Result<Vec<f64>, SearchError> {
    let structure = model.frame().0.build().unwrap_or_else(|error| panic!("{seed}: {error}\n{model:?}"));
    let found = structure.frequencies(COUNT)?;
    assert!(found.iter().all(|own| own.is_proven), "{seed}");
    Ok(found.iter().flat_map(|own| std::iter::repeat_n(own.omega, own.multiplicity as usize)).take(COUNT).collect())
}

/// The largest relative difference of two lists, of what is above the rest of rounding.
fn difference(one: &[f64], other: &[f64]) -> f64 {
    let largest = one.iter().fold(0.0, |sum: f64, own| sum.max(*own));
    one.iter().zip(other).map(|(one, other)| (one - other).abs() / one.max(1e-3 * largest)).fold(0.0, f64::max)
}

/// How far frequencies of structures and of what a function makes of them differ: the worst of some seeds.
fn worst(seeds: Range<u64>, span: f64, other: impl Fn(&Model) -> Model) -> f64 {
    let mut worst = 0.0_f64;
    for seed in seeds {
        let model = random_model(seed, span);
        let [one, other] = [&model, &other(&model)].map(|model| frequencies(model, seed));
        let (Ok(one), Ok(other)) = (&one, &other) else { panic!("{seed}: {one:?} {other:?}") };
        let own = difference(one, other);
        assert!(own < 1e-9, "{seed}: {own:e}\n{one:?}\n{other:?}");
        worst = worst.max(own);
    }
    worst
}

#[test]
fn turned_structures_have_the_same_frequencies() {
    let by = rotation([0.7, -0.4, 1.1]);
    let worst = worst(0..60, 1.0, |model| model.turned(&by));
    assert!(worst < 1e-12, "{worst:e}");
}

/// A thousand of them, whose parameters are up to 1e±4.
#[test]
#[ignore = "long: run by .ci/long"]
fn turned_structures_of_any_parameters_have_the_same_frequencies() {
    let by = rotation([-1.7, 0.8, 0.3]);
    let worst = worst(1000..2000, 4.0, |model| model.turned(&by));
    println!("turned: at most {worst:.1e}");
}

#[test]
fn cut_beams_have_the_same_frequencies() {
    let worst = worst(0..60, 1.0, |model| model.cut(0.37));
    assert!(worst < 1e-12, "{worst:e}");
}

/// A thousand of them, whose parameters are up to 1e±4.
#[test]
#[ignore = "long: run by .ci/long"]
fn cut_beams_of_any_parameters_have_the_same_frequencies() {
    let worst = worst(2000..3000, 4.0, |model| model.cut(0.37));
    println!("cut: at most {worst:.1e}");
}

/// The displacements of a point and the loads on it.
fn asked(point: Point<Space>) -> ([PlaneEntry<InFrame>; 6], [PlaneLoad<InFrame>; 6]) {
    let displaced = [
        point.displacement_x(),
        point.displacement_y(),
        point.displacement_z(),
        point.rotation_x(),
        point.rotation_y(),
        point.rotation_z(),
    ];
    let loads =
        [point.force_x(), point.force_y(), point.force_z(), point.torque_x(), point.torque_y(), point.torque_z()];
    (displaced, loads)
}

/// The receptances between two points.
fn receptances(structure: &Structure<Space>, [loaded, read]: [Point<Space>; 2], omega: f64) -> [[f64; 6]; 6] {
    asked(read)
        .0
        .map(|entry| asked(loaded).1.map(|load| structure.frequency_response(load, entry).unwrap().at(omega).unwrap()))
}

/// Both halves of a motion or a load of six, turned.
fn turned_both(by: &[[f64; 3]; 3], [x, y, z, rx, ry, rz]: [f64; 6]) -> [f64; 6] {
    let ([a, b, c], [p, q, r]) = (turned(by, [x, y, z]), turned(by, [rx, ry, rz]));
    [a, b, c, p, q, r]
}

#[test]
fn responses_are_reciprocal_and_turn_with_the_structure() {
    let by = rotation([0.7, -0.4, 1.1]);
    for seed in 0..40 {
        let (model, omega) = (random_model(seed, 1.0), 0.3 + 0.1 * seed as f64);
        let (frame, points) = model.frame();
        let structure = frame.build().unwrap();
        let (other_frame, other_points) = model.turned(&by).frame();
        let other = other_frame.build().unwrap();
        let (one, two) = (1, model.beams[model.beams.len() - 1].ends[1]);
        let own = receptances(&structure, [points[one], points[two]], omega);
        let back = receptances(&structure, [points[two], points[one]], omega);
        let elsewhere = receptances(&other, [other_points[one], other_points[two]], omega);
        let largest = own.iter().flatten().fold(0.0, |sum: f64, entry| sum.max(entry.abs()));
        // R H Rᵀ, row by row and column by column
        let columns: [[f64; 6]; 6] = std::array::from_fn(|k| turned_both(&by, own.map(|row| row[k])));
        let rows: [[f64; 6]; 6] = std::array::from_fn(|row| turned_both(&by, columns.map(|column| column[row])));
        for row in 0..6 {
            for column in 0..6 {
                let [one, other] = [own[row][column], back[column][row]];
                assert!((one - other).abs() <= 1e-14 * largest, "{seed}: {one} {other}");
                let [one, other] = [rows[row][column], elsewhere[row][column]];
                assert!((one - other).abs() <= 1e-11 * largest, "{seed} {row} {column}: {one} {other} of {largest}");
            }
        }
    }
}

//! How cost grows: time per evaluation against the number of elements, evaluations and time per root against the number of roots
//! and against the mode number, all in one run, with the exponents of the power laws that fit best. Prints Markdown tables.
//!
//! `cargo bench --bench growth`. Times are medians of many rounds; evaluations are the same in every run.

use mstmm::prelude::*;
use mstmm::{Scaled, SearchError};
use std::hint::black_box;
use std::time::Instant;
use subjects::{PinnedBeam, PinnedBeamSystem, around, chain, valid};

pub mod subjects;

const SIZES: [usize; 4] = [1, 10, 100, 1000];

/// Rounds of a measurement, each of some ten microseconds or more.
const ROUNDS: usize = 200;

/// Median time of a call [ns].
fn median(mut call: impl FnMut()) -> f64 {
    let mut time = |calls: u32| {
        let start = Instant::now();
        (0..calls).for_each(|_| call());
        start.elapsed().as_secs_f64() * 1e9 / f64::from(calls)
    };
    let calls = (20_000.0 / time(10)).ceil().max(1.0) as u32;
    let mut rounds: Vec<f64> = (0..ROUNDS).map(|_| time(calls)).collect();
    rounds.sort_by(f64::total_cmp);
    rounds[ROUNDS / 2]
}

/// Exponent of the power law through points, by least squares of the logarithms.
fn exponent(points: &[[f64; 2]]) -> f64 {
    let logarithms: Vec<[f64; 2]> = points.iter().map(|point| point.map(f64::ln)).collect();
    let mean = |axis: usize| logarithms.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64;
    let [x, y] = [mean(0), mean(1)];
    let sum = |f: fn(f64, f64) -> f64| logarithms.iter().map(|point| f(point[0] - x, point[1] - y)).sum::<f64>();
    sum(|x, y| x * y) / sum(|x, _| x * x)
}

/// A chain of beams: Δ, and Δ with its count.
fn elements() {
    println!("| elements | Δ [ns] | per element | with count [ns] | per element |");
    println!("|---|---|---|---|---|");
    let rows = SIZES.map(|size| {
        let chain = chain(size);
        let plain = median(|| {
            let value: Scaled<f64> = black_box(&chain).characteristic(black_box(30.0));
            black_box(value);
        });
        let count = median(|| {
            black_box(black_box(&chain).count_below(black_box(30.0)));
        });
        let n = size as f64;
        println!("| {size} | {plain:.0} | {:.1} | {count:.0} | {:.1} |", plain / n, count / n);
        [n, plain, count]
    });
    let fitted = |column: usize| exponent(&rows.map(|row| [row[0], row[column]]));
    println!("\ntime ∝ elements^{:.3}, with count ∝ elements^{:.3}\n", fitted(1), fitted(2));
}

/// Evaluations and time [ns] of a search.
fn search<F>(find: F) -> Result<[f64; 2], SearchError>
where
    F: Fn() -> Result<usize, SearchError>,
{
    let evaluations = find()?;
    let time = median(|| {
        let _ = black_box(find());
    });
    Ok([evaluations as f64, time])
}

/// A row of one of the two tables of roots.
fn print(key: usize, [evaluations, time]: [f64; 2], roots: f64) {
    let per_root = time / roots / 1e3;
    println!("| {key} | {evaluations} | {:.2} | {per_root:.3} | {:.1} |", evaluations / roots, time / evaluations);
}

/// The first so many roots of the beam, by one search.
fn first<const N: usize>(beam: &PinnedBeamSystem) -> Result<[f64; 3], SearchError> {
    let cost = search(|| black_box(beam).first_frequencies::<N>().map(|found| found.evaluations()))?;
    print(N, cost, N as f64);
    Ok([N as f64, cost[0], cost[1]])
}

/// Searches of one beam.
fn roots() -> Result<(), SearchError> {
    let beam = valid(PinnedBeam {}.build());
    println!("| first roots | evaluations | per root | µs per root | ns per evaluation |");
    println!("|---|---|---|---|---|");
    let rows =
        [first::<1>(&beam)?, first::<10>(&beam)?, first::<100>(&beam)?, first::<1000>(&beam)?, first::<10_000>(&beam)?];
    let fitted = |column: usize| exponent(&rows.map(|row| [row[0], row[column]]));
    println!("\nevaluations ∝ roots^{:.3}, time ∝ roots^{:.3}\n", fitted(1), fitted(2));
    println!("| mode alone | evaluations | per root | µs per root | ns per evaluation |");
    println!("|---|---|---|---|---|");
    let mut rows = Vec::new();
    for mode in SIZES.into_iter().chain([10_000]) {
        let range = around(mode);
        let cost = search(|| {
            black_box(&beam).natural_frequencies::<1>(black_box(range.clone())).map(|found| found.evaluations())
        })?;
        print(mode, cost, 1.0);
        rows.push((mode as f64, cost));
    }
    let fitted = |axis: usize| exponent(&rows.iter().map(|(mode, cost)| [*mode, cost[axis]]).collect::<Vec<_>>());
    println!("\nevaluations ∝ mode^{:.3}, time ∝ mode^{:.3}", fitted(0), fitted(1));
    Ok(())
}

fn main() -> Result<(), SearchError> {
    elements();
    roots()
}

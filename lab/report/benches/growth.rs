//! How cost grows with the number of elements, the number of roots and the mode number, all in one run, with the exponents of
//! the power laws that fit best. Prints Markdown tables.
//!
//! `cargo bench --bench growth`. Evaluations are the same in every run, times are the least of many rounds.

use mstmm::prelude::*;
use report::ReportError;
use report::growth::{Cantilever, ELEMENTS, Pinned, Point, exponent, leap, over_elements, over_roots};
use std::f64::consts::PI;

/// The largest number of roots.
const ROOTS: usize = 1000;

/// A chain of beams.
fn elements() -> Result<(), ReportError> {
    let costs = over_elements(&ELEMENTS)?;
    println!("| elements | evaluation [ns] | per element | search [µs] | search / evaluation |");
    println!("|---|---|---|---|---|");
    for (evaluation, search) in costs.evaluation.iter().zip(&costs.search) {
        let size = evaluation.size as f64;
        let [one, all] = [evaluation.seconds * 1e9, search.seconds * 1e6];
        println!("| {size} | {one:.0} | {:.1} | {all:.1} | {:.0} |", one / size, all * 1e3 / one);
    }
    let [one, all] = [&costs.evaluation, &costs.search].map(|points| exponent(points));
    println!("\nevaluation ∝ elements^{one:.3}, search ∝ elements^{all:.3}\n");
    Ok(())
}

/// Evaluations per root of the search for the first so many roots.
fn evaluations(system: &impl Undamped<Parameter = f64>, size: usize) -> Result<f64, ReportError> {
    macro_rules! of {
        ($($size:literal)*) => {
            match size {
                $($size => system.first_frequencies::<$size>()?.evaluations(),)*
                _ => 0,
            }
        };
    }
    Ok(of!(1 2 5 10 20 50 100 200 500 1000) as f64 / size as f64)
}

/// Times per root, with the evaluations per root that some function tells.
fn print(
    what: &str,
    times: &[Point],
    evaluations: impl Fn(usize) -> Result<f64, ReportError>,
) -> Result<(), ReportError> {
    println!("| {what} | evaluations per root | µs per root | ns per evaluation |");
    println!("|---|---|---|---|");
    for &Point { size, seconds } in times {
        let count = evaluations(size)?;
        println!("| {size} | {count:.2} | {:.3} | {:.1} |", seconds * 1e6, seconds * 1e9 / count);
    }
    match leap(times) {
        Some(size) => println!("\ntime per root leaps at {size}\n"),
        None => println!("\ntime per root ∝ number^{:.3}\n", exponent(times)),
    }
    Ok(())
}

fn main() -> Result<(), ReportError> {
    elements()?;
    let (pinned, cantilever) = (Pinned {}.build()?, Cantilever {}.build()?);
    let times = over_roots(ROOTS)?;
    print("first roots of a pinned beam", &times.pinned, |size| evaluations(&pinned, size))?;
    print("first roots of a cantilever", &times.cantilever, |size| evaluations(&cantilever, size))?;
    print("that mode of a pinned beam alone", &times.alone, |mode| {
        let [start, end] = [-0.5, 0.5].map(|half| ((mode as f64 + half) * PI).powi(2));
        Ok(pinned.natural_frequencies::<1>(start..=end)?.evaluations() as f64)
    })
}

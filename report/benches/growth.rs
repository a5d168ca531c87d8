//! How cost grows with the number of elements, the number of roots and the mode number, all in one run, with the exponents of
//! the power laws that fit best. Prints Markdown tables.
//!
//! `cargo bench --bench growth`. Evaluations are the same in every run, times are the least of many rounds.

use mstmm::prelude::*;
use report::ReportError;
use report::growth::{ELEMENTS, Point, exponent, over_elements, over_roots};
use std::f64::consts::PI;

/// The largest number of roots.
const ROOTS: usize = 1000;

/// Mode numbers that are searched for alone.
const MODES: [u32; 7] = [1, 3, 10, 30, 100, 1000, 10_000];

system! {
    /// The cantilever whose roots are timed.
    struct Cantilever {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free
}

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

/// Evaluations of the search for the first so many roots of the cantilever.
fn evaluations(system: &CantileverSystem, size: usize) -> Result<usize, ReportError> {
    macro_rules! of {
        ($($size:literal)*) => {
            match size {
                $($size => system.first_frequencies::<$size>()?.evaluations(),)*
                _ => 0,
            }
        };
    }
    Ok(of!(1 2 5 10 20 50 100 200 500 1000))
}

/// One beam with its first roots, and with one of them.
fn roots() -> Result<(), ReportError> {
    let system = Cantilever {}.build()?;
    println!("| first roots | evaluations | per root | µs per root | ns per evaluation |");
    println!("|---|---|---|---|---|");
    let times = over_roots(ROOTS)?;
    let mut counts = Vec::new();
    for &Point { size, seconds } in &times {
        let total = evaluations(&system, size)?;
        let each = total as f64 / size as f64;
        println!("| {size} | {total} | {each:.2} | {:.3} | {:.1} |", seconds * 1e6, seconds * 1e9 / each);
        // an exponent is that of any cost, not of seconds alone
        counts.push(Point { size, seconds: each });
    }
    let [time, count] = [&times, &counts].map(|points| exponent(points));
    println!("\nevaluations per root ∝ roots^{count:.3}, time per root ∝ roots^{time:.3}\n");
    println!("| mode alone | evaluations |");
    println!("|---|---|");
    for mode in MODES {
        // the cantilever's z are near (n - 1/2)π, so that this range holds one, off its middle
        let [start, end] = [0.8, 0.1].map(|share| ((f64::from(mode) - share) * PI).powi(2));
        println!("| {mode} | {} |", system.natural_frequencies::<2>(start..=end)?.evaluations());
    }
    Ok(())
}

fn main() -> Result<(), ReportError> {
    elements()?;
    roots()
}

//! Solves the examples by the paper's searches on the overall determinant, and by the certified ones.

use crate::models::{
    DampedOscillatorSystem, RestrainedBeamSystem, SpringAndMassSystem, TipBodySystem, TwoSpansSystem,
    damped_oscillator, heavy_tip_body, light_tip_body, restrained_beam, spring_and_mass, two_spans,
};
use crate::reference::{Example, Failure, Search};
use core::time::Duration;
use mstmm::prelude::*;
use mstmm::search::System;
use std::time::Instant;

/// Room for the minima of one search, ends and edges of its range included.
const CAPACITY: usize = 32;

/// An example with the results of every method that was applied to it.
#[derive(Debug)]
pub struct Solved {
    /// Width of the overall matrix.
    pub size: usize,
    /// The frequency unit sqrt(EI/(m l⁴)) [rad/s].
    pub unit: f64,
    /// One for each method, the paper's first.
    pub solutions: Vec<Solution>,
}

/// What one method found, and what it cost.
#[derive(Debug)]
pub struct Solution {
    /// Name of the method.
    pub method: &'static str,
    /// Eigenvalues λ [rad/s] in the search range, by ascending imaginary part; undamped λ = iω.
    pub roots: Vec<Complex<f64>>,
    /// Evaluations of the determinant.
    pub evaluations: usize,
    /// Time of the search.
    pub time: Duration,
}

/// Builds a model and applies methods to it: a macro, since each model is a type of its own.
macro_rules! solved {
    ($model:expr, $system:ident, $search:expr, [$($method:ident),*]) => {{
        let (model, search) = ($model, $search);
        let system = model.build()?;
        let unit = (model.bending_stiffness / model.mass_per_length).sqrt() / (model.length * model.length);
        Ok(Solved { size: $system::N, unit, solutions: vec![$($method(&system, search)?),*] })
    }};
}

/// Solves an example by all methods.
///
/// # Errors
/// There is no model for it, or a search fails.
pub fn solve(example: &Example) -> Result<Solved, Failure> {
    let search = &example.search;
    match example.id.as_str() {
        "4.1a" => solved!(light_tip_body(), TipBodySystem, search, [scan_line, certified_line]),
        "4.1b" => solved!(heavy_tip_body(), TipBodySystem, search, [scan_line, certified_line]),
        "4.2" => solved!(restrained_beam(), RestrainedBeamSystem, search, [scan_line, certified_line]),
        "4.3" => solved!(spring_and_mass(), SpringAndMassSystem, search, [scan_line, certified_line]),
        "4.4" => solved!(two_spans(), TwoSpansSystem, search, [scan_line, certified_line]),
        "4.5" => solved!(damped_oscillator(), DampedOscillatorSystem, search, [scan_rectangle, certified_rectangle]),
        unknown => Err(format!("there is no model for example {unknown}").into()),
    }
}

/// The paper's method for undamped systems: the minima of |Δ(ω)| inside the range.
fn scan_line<S: Evaluate<f64>>(system: &S, search: &Search) -> Result<Solution, Failure> {
    let Search::Line { range, points, tolerance } = search else {
        return Err("an undamped system is searched on a line".into());
    };
    let start = Instant::now();
    let minima = fmin1d::<CAPACITY, _>(|omega| system.overall_determinant(omega), range.clone(), *points, *tolerance)?;
    let time = start.elapsed();
    let roots = minima.iter().filter(|minimum| !minimum.at_end).map(|minimum| Complex::new(0.0, minimum.x)).collect();
    Ok(Solution { method: "fmin1d", roots, evaluations: minima.evaluations(), time })
}

/// The paper's method for damped systems: the minima of |Δ(-δ + iω)| inside the rectangle.
fn scan_rectangle<S: Evaluate<Complex<f64>>>(system: &S, search: &Search) -> Result<Solution, Failure> {
    let Search::Rectangle { ranges, points, tolerance } = search else {
        return Err("a damped system is searched on a rectangle".into());
    };
    let start = Instant::now();
    let minima = fmin2d::<CAPACITY, _>(
        |omega, delta| system.overall_determinant(Complex::new(-delta, omega)),
        ranges.clone(),
        *points,
        [*tolerance; 2],
    )?;
    let time = start.elapsed();
    let interior = minima.iter().filter(|minimum| !minimum.at_edge);
    let mut roots: Vec<_> = interior.map(|minimum| Complex::new(-minimum.y, minimum.x)).collect();
    roots.sort_by(|a, b| a.im.total_cmp(&b.im));
    Ok(Solution { method: "fmin2d", roots, evaluations: minima.evaluations(), time })
}

/// The certified search for undamped systems, in the paper's range.
fn certified_line<S>(system: &S, search: &Search) -> Result<Solution, Failure>
where
    S: Undamped + System<Parameter = f64>,
{
    let Search::Line { range, .. } = search else {
        return Err("an undamped system is searched on a line".into());
    };
    let start = Instant::now();
    let found = system.natural_frequencies::<CAPACITY>(range.clone())?;
    let time = start.elapsed();
    let roots = found.iter().map(|root| Complex::new(0.0, root.omega)).collect();
    Ok(Solution { method: "certified", roots, evaluations: found.evaluations(), time })
}

/// The certified search for damped systems, in the paper's rectangle.
fn certified_rectangle<S>(system: &S, search: &Search) -> Result<Solution, Failure>
where
    S: Eigenvalues<Parameter = f64> + Spectrum,
{
    let Search::Rectangle { ranges: [omega, delta], .. } = search else {
        return Err("a damped system is searched on a rectangle".into());
    };
    let region = Region { re: -delta.end()..=-delta.start(), im: omega.clone() };
    let start = Instant::now();
    let found = system.eigenvalues::<CAPACITY>(region)?;
    let time = start.elapsed();
    let roots = found.iter().map(|root| root.lambda).collect();
    Ok(Solution { method: "certified", roots, evaluations: found.evaluations(), time })
}

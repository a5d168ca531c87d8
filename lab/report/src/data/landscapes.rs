//! |Δ| of the examples over its trend, in the ranges of the paper's searches, and the roots in them.

use super::trend::less_trend;
use crate::error::ReportError;
use mstmm::number::{Frequency, InLanes, Scaled};
use mstmm::prelude::*;
use mstmm::search::{InBlocks, SearchError, System};
use paper::models::*;
use paper::{Search, examples};
use std::f64::consts::LOG10_2;
use std::ops::RangeInclusive;

/// Room for the roots in a range.
const CAPACITY: usize = 32;
/// Distances from a root, as shares of the range, at which the pit around it is sampled: down to what no picture shows any more.
const PIT: [f64; 8] = [1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 5e-4, 1e-3, 2e-3];
/// Half of the width of the damped example's map as a share of its height, so that its scales can be equal.
const HALF_WIDTH: f64 = 0.36;

/// |Δ| of an undamped example.
#[derive(Clone, Debug)]
pub(crate) struct Landscape {
    pub(crate) id: String,
    /// ω [rad/s] and log₁₀ of |Δ| over its trend.
    pub(crate) samples: Vec<(f64, f64)>,
    /// Certified frequencies [rad/s].
    pub(crate) roots: Vec<f64>,
}

/// |Δ| of the damped example over its trend, sampled in rows of equal Im λ.
#[derive(Clone, Debug)]
pub(crate) struct HeatMap {
    pub(crate) id: String,
    pub(crate) re: RangeInclusive<f64>,
    pub(crate) im: RangeInclusive<f64>,
    /// Samples along Re λ.
    pub(crate) columns: usize,
    /// log₁₀ of |Δ| over its trend.
    pub(crate) values: Vec<f64>,
    /// Real and imaginary parts of the paper's search.
    pub(crate) searched: [RangeInclusive<f64>; 2],
    /// Certified eigenvalues [1/s].
    pub(crate) roots: Vec<Complex<f64>>,
}

/// All of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Landscapes {
    pub(crate) undamped: Vec<Landscape>,
    pub(crate) damped: Vec<HeatMap>,
}

/// Samples all examples, with so many points along a line or an edge.
pub(crate) fn landscapes(points: usize) -> Result<Landscapes, ReportError> {
    let mut list = Landscapes::default();
    for example in examples().map_err(ReportError::Paper)? {
        let id = example.id.as_str();
        match example.search {
            Search::Line { range, .. } => list.undamped.push(match id {
                "4.1a" => on_line(id, &light_tip_body().build()?, range, points),
                "4.1b" => on_line(id, &heavy_tip_body().build()?, range, points),
                "4.2" => on_line(id, &restrained_beam().build()?, range, points),
                "4.3" => on_line(id, &spring_and_mass().build()?, range, points),
                "4.4" => on_line(id, &two_spans().build()?, range, points),
                _ => return Err(ReportError::Paper(format!("there is no undamped model for example {id}").into())),
            }?),
            Search::Rectangle { ranges, .. } => list.damped.push(in_rectangle(id, ranges, points)?),
        }
    }
    Ok(list)
}

fn on_line<Y>(id: &str, system: &Y, range: RangeInclusive<f64>, points: usize) -> Result<Landscape, ReportError>
where
    Y: Undamped + System<Parameter = f64>,
{
    let length = range.end() - range.start();
    let found = system.natural_frequencies::<CAPACITY>(range.clone())?;
    let roots: Vec<f64> = found.iter().map(|root| root.omega).collect();
    let around = |root: f64| PIT.iter().flat_map(move |share| [root - share * length, root + share * length]);
    let pits = roots.iter().flat_map(|&root| around(root)).filter(|omega| range.contains(omega));
    let omegas: Vec<f64> = even(&range, points).chain(pits).collect();
    let places: Vec<_> = omegas.iter().map(|&omega| Complex::new(0.0, omega)).collect();
    // pits are no part of the trend
    let values = less_trend(&places, &logarithms(system, &omegas, f64::abs)?, points)?;
    let mut samples: Vec<(f64, f64)> = omegas.into_iter().zip(values).collect();
    samples.sort_by(|one, other| one.0.total_cmp(&other.0));
    Ok(Landscape { id: id.to_owned(), samples, roots })
}

/// The eigenvalues lie along the imaginary axis in a rectangle so slender that each pit would fill its width: the map is wider.
fn in_rectangle(id: &str, [omega, delta]: [RangeInclusive<f64>; 2], points: usize) -> Result<HeatMap, ReportError> {
    let system = damped_oscillator().build()?;
    let searched = [-delta.end()..=-delta.start(), omega.clone()];
    let found = system.eigenvalues::<CAPACITY>(Region { re: searched[0].clone(), im: omega.clone() })?;
    let half = HALF_WIDTH * (omega.end() - omega.start());
    let (re, im) = (-half..=half, omega);
    let rows = even(&im, points).map(|im| even(&re, points).map(move |re| Complex::new(re, im)));
    let places: Vec<_> = rows.flatten().collect();
    let values = less_trend(&places, &logarithms(&system, &places, Complex::norm)?, places.len())?;
    let roots = found.iter().map(|root| root.lambda).collect();
    Ok(HeatMap { id: id.to_owned(), re, im, columns: points, values, searched, roots })
}

/// Points from end to end of a range.
fn even(range: &RangeInclusive<f64>, points: usize) -> impl Iterator<Item = f64> + use<> {
    let (start, end) = (*range.start(), *range.end());
    (0..points).map(move |n| start + (end - start) * n as f64 / (points - 1) as f64)
}

/// log₁₀ |Δ| at many frequencies.
fn logarithms<S, Y>(system: &Y, frequencies: &[S], modulus: fn(S) -> f64) -> Result<Vec<f64>, SearchError>
where
    S: Frequency<f64> + InLanes,
    Y: InBlocks<S> + System<Parameter = f64>,
{
    let mut values = vec![Scaled::new(S::zero(), 0); frequencies.len()];
    system.characteristics(frequencies, &mut values)?;
    Ok(values.iter().map(|value| modulus(value.mantissa()).log10() + value.exponent() as f64 * LOG10_2).collect())
}

//! Counts that prove lists of roots complete: N(ω) over a range and close to a root, and counts in rectangles.

use crate::error::ReportError;
use mstmm::prelude::*;
use mstmm::search::{SearchError, System};
use paper::models::{damped_oscillator, two_spans};
use rivals::scenes::WEAK;
use rivals::scenes::extremes::Twins;

/// The mode of the example at which its counts are magnified.
const MAGNIFIED: usize = 3;
/// Distances per decade in a magnified picture.
const PER_DECADE: i32 = 8;
/// Halvings of the rectangle of the damped example, in turns along both axes.
const HALVINGS: u32 = 7;

/// N(ω), the number of natural frequencies below ω.
#[derive(Clone, Debug)]
pub(crate) struct Staircase {
    /// ω [rad/s] and N.
    pub(crate) samples: Vec<(f64, u64)>,
    pub(crate) roots: Vec<Certified>,
}

/// A certified frequency with the counts at both ends of its interval.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Certified {
    pub(crate) root: NaturalFrequency,
    /// N at the lower and at the upper end.
    pub(crate) counts: [u64; 2],
}

/// N in the neighbourhood of a frequency.
#[derive(Clone, Debug)]
pub(crate) struct Magnified {
    /// Distance from the frequency, relative to it, and N there.
    pub(crate) samples: Vec<(f64, u64)>,
    /// Ends of the certified intervals, as such distances.
    pub(crate) intervals: Vec<[f64; 2]>,
}

/// A rectangle of the complex plane and the number of eigenvalues in it.
#[derive(Clone, Debug)]
pub(crate) struct Cell {
    pub(crate) region: Region<f64>,
    pub(crate) count: u64,
}

/// The damped example's rectangle, halved where something is in it.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    /// Those that are not halved again: they fill the rectangle.
    pub(crate) leaves: Vec<Cell>,
    /// Certified eigenvalues [1/s].
    pub(crate) roots: Vec<Complex<f64>>,
}

/// All counts.
#[derive(Clone, Debug)]
pub(crate) struct Counts {
    pub(crate) spans: Staircase,
    pub(crate) mode: Magnified,
    pub(crate) twins: Vec<Certified>,
    pub(crate) pair: Magnified,
    pub(crate) cells: Cells,
}

/// Counts with so many points along an axis.
pub(crate) fn counts(points: usize) -> Result<Counts, ReportError> {
    let (spans, twins) = (two_spans().build()?, Twins { stiffness: WEAK }.build()?);
    let roots = certified(&spans, &spans.first_frequencies::<5>()?)?;
    let centre = roots.get(MAGNIFIED - 1).map_or(f64::NAN, |root| root.root.omega);
    let pair = certified(&twins, &twins.first_frequencies::<2>()?)?;
    let middle = pair.iter().map(|root| root.root.omega).sum::<f64>() / pair.len() as f64;
    Ok(Counts {
        mode: magnified(&spans, centre, &roots)?,
        spans: Staircase { samples: staircase(&spans, &roots, points)?, roots },
        pair: magnified(&twins, middle, &pair)?,
        twins: pair,
        cells: cells(&damped_oscillator().build()?)?,
    })
}

fn certified<Y>(system: &Y, roots: &[NaturalFrequency]) -> Result<Vec<Certified>, SearchError>
where
    Y: Undamped + System<Parameter = f64>,
{
    let with_counts = |&root: &NaturalFrequency| {
        Ok(Certified { root, counts: [system.count_below(root.lower)?, system.count_below(root.upper)?] })
    };
    roots.iter().map(with_counts).collect()
}

/// N from rest to beyond the last root.
fn staircase<Y>(system: &Y, roots: &[Certified], points: usize) -> Result<Vec<(f64, u64)>, SearchError>
where
    Y: Undamped + System<Parameter = f64>,
{
    let end = 1.06 * roots.iter().map(|root| root.root.upper).fold(0.0, f64::max);
    let even = (0..points).map(|n| end * n as f64 / (points - 1) as f64);
    let mut omegas: Vec<f64> = even.chain(roots.iter().flat_map(|root| [root.root.lower, root.root.upper])).collect();
    omegas.sort_by(f64::total_cmp);
    omegas.into_iter().map(|omega| Ok((omega, system.count_below(omega)?))).collect()
}

/// N at distances from a tenth to a rounding, but for those inside of an interval, where nobody can tell.
fn magnified<Y>(system: &Y, centre: f64, roots: &[Certified]) -> Result<Magnified, SearchError>
where
    Y: Undamped + System<Parameter = f64>,
{
    let distances = (PER_DECADE..=15 * PER_DECADE).map(|n| 10f64.powf(-f64::from(n) / f64::from(PER_DECADE)));
    let both = distances.flat_map(|distance| [-distance, distance]);
    let is_inside = |omega: f64| roots.iter().any(|root| root.root.lower <= omega && omega <= root.root.upper);
    let places = both.map(|distance| (distance, centre + distance * centre)).filter(|(_, omega)| !is_inside(*omega));
    let mut samples: Vec<(f64, u64)> = places
        .map(|(distance, omega)| Ok((distance, system.count_below(omega)?)))
        .collect::<Result<_, SearchError>>()?;
    samples.sort_by(|one, other| one.0.total_cmp(&other.0));
    let relative = |omega: f64| (omega - centre) / centre;
    let near = roots.iter().filter(|root| relative(root.root.omega).abs() < 0.1);
    Ok(Magnified { samples, intervals: near.map(|root| [root.root.lower, root.root.upper].map(relative)).collect() })
}

fn cells<Y>(system: &Y) -> Result<Cells, SearchError>
where
    Y: Spectrum + System<Parameter = f64>,
{
    let region = Region { re: -300.0..=5.0, im: -10.0..=12_000.0 };
    let roots = system.eigenvalues_in(region.clone())?.iter().map(|root| root.lambda).collect();
    let mut leaves = Vec::new();
    halve(system, region, HALVINGS, &mut leaves)?;
    Ok(Cells { leaves, roots })
}

/// Counts in a region, and where something is in it, in its halves.
fn halve<Y>(system: &Y, region: Region<f64>, halvings: u32, leaves: &mut Vec<Cell>) -> Result<(), SearchError>
where
    Y: Spectrum + System<Parameter = f64>,
{
    let count = system.count_in(region.clone())?;
    if count == 0 || halvings == 0 {
        leaves.push(Cell { region, count });
        return Ok(());
    }
    let range = if halvings.is_multiple_of(2) { &region.re } else { &region.im };
    let (start, end) = (*range.start(), *range.end());
    let middle = start + (end - start) / 2.0;
    for half in [start..=middle, middle..=end] {
        let Region { re, im } = region.clone();
        let half = if halvings.is_multiple_of(2) { Region { re: half, im } } else { Region { re, im: half } };
        halve(system, half, halvings - 1, leaves)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Between the roots of a list N is the number of those below, and each interval has one more above than below.
    #[test]
    fn counts_are_those_of_the_lists() {
        let counts = counts(50).unwrap();
        for (n, root) in (0..).zip(&counts.spans.roots) {
            assert_eq!(root.counts, [n, n + 1]);
        }
        for &(omega, count) in &counts.spans.samples {
            let below = counts.spans.roots.iter().filter(|root| root.root.upper <= omega).count();
            assert_eq!(count, below as u64, "at {omega}");
        }
    }

    /// The spring between the twins parts their frequencies by a relative 3.2e-9: seen from the middle, one is on each side.
    #[test]
    fn a_close_pair_has_a_count_of_one_in_its_gap() {
        let pair = counts(2).unwrap().pair;
        assert_eq!(pair.intervals.len(), 2);
        for &(distance, count) in &pair.samples {
            let expected = if distance < -1.7e-9 {
                0
            } else if distance < 1.5e-9 {
                1
            } else {
                2
            };
            assert_eq!(count, expected, "at {distance:e}");
        }
    }

    /// Rectangles fill the whole, each eigenvalue is in one with a count, and the counts add up to the list.
    #[test]
    fn counts_in_rectangles_are_those_of_the_list() {
        let Cells { leaves, roots } = counts(2).unwrap().cells;
        let width = |range: &std::ops::RangeInclusive<f64>| range.end() - range.start();
        let area: f64 = leaves.iter().map(|leaf| width(&leaf.region.re) * width(&leaf.region.im)).sum();
        assert!((area / (305.0 * 12_010.0) - 1.0).abs() < 1e-12);
        for Cell { region, count } in leaves {
            let inside = roots.iter().filter(|root| region.re.contains(&root.re) && region.im.contains(&root.im));
            assert_eq!(inside.count() as u64, count, "{region:?}");
        }
    }
}

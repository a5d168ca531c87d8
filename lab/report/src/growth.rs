//! How cost grows with the size of a system and with the number of roots.

use crate::clock::least_seconds;
use crate::error::ReportError;
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;
use std::f64::consts::PI;
use std::hint::black_box;

/// Numbers of elements in [`over_elements`].
pub const ELEMENTS: [usize; 10] = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/// Steeper than this power of the size no cost grows here: it leaps.
const LEAP: f64 = 2.5;

/// A size and what it costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Number of elements or of roots.
    pub size: usize,
    /// Time in s.
    pub seconds: f64,
}

/// Costs of a chain of beams, pinned at every joint, by the number of beams.
#[derive(Clone, Debug, Default)]
pub struct OverElements {
    /// One evaluation of Δ by planes.
    pub evaluation: Vec<Point>,
    /// The certified search for the lowest frequency.
    pub search: Vec<Point>,
}

/// Measures chains of so many beams.
///
/// # Errors
/// Those of the search.
pub fn over_elements(sizes: &[usize]) -> Result<OverElements, ReportError> {
    let mut costs = OverElements::default();
    for &size in sizes {
        let steps = chain(size)?;
        let list = StepList::new(&steps)?;
        // between the roots of a span
        let omega = 2.0 * PI * PI;
        let seconds = least_seconds(|| list.characteristic(black_box(omega)));
        costs.evaluation.push(Point { size, seconds });
        list.first_frequencies::<1>()?;
        let seconds = least_seconds(|| black_box(&list).first_frequencies::<1>());
        costs.search.push(Point { size, seconds });
    }
    Ok(costs)
}

/// Beams with EI = m = l = 1 in a row, pinned at every joint.
fn chain(beams: usize) -> Result<Vec<ListStep<AnyUndamped<f64>>>, ReportError> {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let span = ListStep::Element(AnyUndamped::try_from(beam)?);
    let mut steps = vec![ListStep::Tip(Support::Pinned), span];
    for _ in 1..beams {
        steps.extend([ListStep::Tip(Support::Pinned), ListStep::Connection(2), span]);
    }
    steps.push(ListStep::Root(Support::Pinned));
    Ok(steps)
}

system! {
    /// Cantilever with EI = m = l = 1.
    #[derive(Debug)]
    pub struct Cantilever {}
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free
}

system! {
    /// Beam on two pins with EI = m = l = 1, whose frequencies are (nπ)².
    #[derive(Debug)]
    pub struct Pinned {}
    pinned -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned
}

/// Time of the certified search for each root of a beam, by mode number.
#[derive(Clone, Debug, Default)]
pub struct OverRoots {
    /// Of a pinned beam, all roots up to that mode: the mean of all.
    pub pinned: Vec<Point>,
    /// The same of a cantilever.
    pub cantilever: Vec<Point>,
    /// Of a pinned beam, that mode alone.
    pub alone: Vec<Point>,
}

/// Measures the modes 1, 2, 5, .. up to a mode number.
///
/// # Errors
/// Those of the search.
pub fn over_roots(most: usize) -> Result<OverRoots, ReportError> {
    let (pinned, cantilever) = (Pinned {}.build()?, Cantilever {}.build()?);
    let mut costs = OverRoots::default();
    // the number of roots is known at compile time
    macro_rules! measure {
        ($list:ident, $system:ident, [$($size:literal),*]) => {
            $(if $size <= most {
                $system.first_frequencies::<$size>()?;
                let seconds = least_seconds(|| black_box(&$system).first_frequencies::<$size>());
                costs.$list.push(Point { size: $size, seconds: seconds / $size as f64 });
            })*
        };
    }
    measure!(pinned, pinned, [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]);
    measure!(cantilever, cantilever, [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]);
    for size in costs.pinned.iter().map(|point| point.size) {
        let end = |half: f64| ((size as f64 + half) * PI).powi(2);
        let seconds = least_seconds(|| black_box(&pinned).natural_frequencies::<1>(black_box(end(-0.5)..=end(0.5))));
        costs.alone.push(Point { size, seconds });
    }
    Ok(costs)
}

/// The size at which the time leaps, so that no power law fits.
pub fn leap(points: &[Point]) -> Option<usize> {
    let slope =
        |pair: &[Point]| (pair[1].seconds / pair[0].seconds).ln() / (pair[1].size as f64 / pair[0].size as f64).ln();
    points.windows(2).find(|pair| slope(pair) > LEAP).map(|pair| pair[1].size)
}

/// The exponent p of `seconds = c sizeᵖ`, by least squares of logarithms over the upper half of their range.
///
/// Small sizes do not take part: what every call costs hides the growth. NaN for less than two sizes.
pub fn exponent(points: &[Point]) -> f64 {
    let sizes = || points.iter().map(|point| point.size as f64);
    let middle = (sizes().fold(f64::INFINITY, f64::min) * sizes().fold(0.0, f64::max)).sqrt();
    let large = || points.iter().filter(|point| point.size as f64 >= middle);
    let logarithms: Vec<_> = large().map(|point| ((point.size as f64).ln(), point.seconds.ln())).collect();
    let count = logarithms.len() as f64;
    let (x, y) = logarithms.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / count, sum.1 + point.1 / count));
    let covariance: f64 = logarithms.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    let variance: f64 = logarithms.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
    covariance / variance
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(law: impl Fn(f64) -> f64) -> Vec<Point> {
        [1, 10, 100, 1000].map(|size| Point { size, seconds: law(size as f64) }).to_vec()
    }

    /// Oracle: powers.
    #[test]
    fn an_exponent_is_that_of_a_power() {
        for power in [0.0, 0.5, 1.0, 2.0] {
            assert!((exponent(&points(|size| 3e-9 * size.powf(power))) - power).abs() < 1e-14);
        }
    }

    #[test]
    fn what_every_call_costs_is_not_growth() {
        assert!((exponent(&points(|size| size + 20.0)) - 1.0).abs() < 0.1);
    }

    #[test]
    fn a_leap_is_not_growth() {
        let points = |law: fn(f64) -> f64| {
            [10, 20, 50, 100].map(|size| Point { size, seconds: law(f64::from(size as u32)) }).to_vec()
        };
        assert_eq!(leap(&points(|size| size.powf(0.5))), None);
        assert_eq!(leap(&points(|size| size * size)), None);
        assert_eq!(leap(&points(|size| if size < 60.0 { 1.0 } else { 20.0 })), Some(100));
    }

    #[test]
    fn a_single_size_has_no_exponent() {
        assert!(exponent(&[Point { size: 1, seconds: 1.0 }]).is_nan());
    }

    #[test]
    fn costs_are_measured_for_every_size() {
        let costs = over_elements(&[1, 3]).unwrap();
        assert_eq!(costs.evaluation.iter().map(|point| point.size).collect::<Vec<_>>(), [1, 3]);
        assert_eq!(over_roots(2).unwrap().alone.len(), 2);
        assert!(costs.search.iter().all(|point| point.seconds > 0.0));
    }
}

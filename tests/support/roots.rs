//! Roots of a determinant of one real variable, found by the paper's search and polished by bisection on its sign.
#![expect(clippy::unwrap_used, reason = "a failing search fails the test that asked for it")]

use core::ops::RangeInclusive;
use mstmm::number::Scaled;
use mstmm::search::{FrequencyList, fmin1d};

/// Room for the roots of one search.
const CAPACITY: usize = 32;

/// Zero between two points of opposite sign, to the last bit.
pub(crate) fn bisect(function: impl Fn(f64) -> f64, mut lower: f64, mut upper: f64) -> f64 {
    let start = function(lower);
    assert!(start * function(upper) < 0.0, "no change of sign between {lower} and {upper}");
    loop {
        let middle = lower + (upper - lower) / 2.0;
        if middle <= lower || middle >= upper {
            return middle;
        }
        if function(middle) * start > 0.0 { lower = middle } else { upper = middle }
    }
}

/// All zeros in `range` at which the determinant changes its sign, upwards.
///
/// An end of the range may be a minimum too, but a zero is found by `fmin1d` as an interior one.
pub(crate) fn zeros(determinant: impl Fn(f64) -> Scaled<f64>, range: RangeInclusive<f64>, points: usize) -> Vec<f64> {
    // far below the distance of two zeros, far above the noise of the determinant
    let tolerance = (range.end() - range.start()) / 1e6;
    let minima = fmin1d::<CAPACITY, _>(&determinant, range, points, tolerance).unwrap();
    let sign = |x| determinant(x).mantissa();
    minima.iter().filter(|m| !m.at_end).map(|m| bisect(sign, m.x - tolerance, m.x + tolerance)).collect()
}

/// Asserts that two ascending lists agree to `tolerance`, relative.
pub(crate) fn assert_same_roots(actual: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(actual.len(), expected.len(), "{actual:?} are not as many as {expected:?}");
    for (actual, expected) in actual.iter().zip(expected) {
        let error = (actual - expected).abs() / expected;
        assert!(error <= tolerance, "{actual} differs from {expected} by {error:e} of it");
    }
}

/// Asserts that two certified lists hold the same roots: both intervals of a root meet, since it is in both, and hold it as often.
pub(crate) fn assert_same_intervals<const N: usize>(
    found: &FrequencyList<f64, N>,
    others: &FrequencyList<f64, N>,
    of: &impl core::fmt::Debug,
) {
    assert_eq!(found.len(), others.len(), "{of:?}: {found:?} and {others:?}");
    for (root, other) in found.iter().zip(others) {
        assert_eq!(root.multiplicity, other.multiplicity, "{of:?}: {root:?} and {other:?}");
        assert!(root.lower <= other.upper && other.lower <= root.upper, "{of:?}: {root:?} and {other:?}");
        for root in [root, other] {
            assert!(root.lower <= root.omega && root.omega <= root.upper, "{of:?}: {root:?}");
        }
    }
}

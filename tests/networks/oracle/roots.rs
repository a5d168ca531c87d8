//! Natural frequencies by bisection on counts.

use super::{Oracle, double};
use mstmm::number::{DoubleDouble, Parameter, Scalar};

/// Relative width of an interval whose middle is the frequency.
const WIDTH: f64 = 1e-25;

/// A frequency below which no count is asked for, and one above.
const RANGE: [f64; 2] = [1e-60, 1e60];

/// Where an interval is cut: elsewhere, if the matrix cannot tell at the middle.
const CUTS: [f64; 5] = [0.5, 0.41, 0.57, 0.31, 0.73];

impl Oracle {
    /// The n-th natural frequency from one on, with repetition; zero if it belongs to a rigid motion.
    ///
    /// The bisection ends early beside frequencies at which the matrix cannot tell.
    pub(crate) fn frequency(&self, n: u64) -> DoubleDouble {
        let is_above = |omega: DoubleDouble| self.count_below(omega).map(|count| count >= n);
        let (mut lower, mut upper) = (double(1.0), double(1.0));
        while is_above(upper) != Some(true) {
            (lower, upper) = (upper, upper * double(4.0));
            assert!(upper.to_f64() < RANGE[1], "there are fewer frequencies than {n}");
        }
        let mut step = double(4.0);
        while is_above(lower) != Some(false) {
            (upper, lower, step) = (lower, lower / step, step * step);
            if lower.to_f64() < RANGE[0] {
                return double(0.0);
            }
        }
        while (upper - lower).to_f64() > WIDTH * upper.to_f64() {
            // far apart, the geometric mean
            let ratio = upper / lower;
            let cut = |part: f64| match ratio > double(2.0) {
                true if part == 0.5 => (lower * upper).sqrt(),
                _ => lower + (upper - lower) * double(part),
            };
            let Some((middle, above)) = CUTS.iter().map(|&part| cut(part)).find_map(|x| Some((x, is_above(x)?))) else {
                break;
            };
            if above { upper = middle } else { lower = middle }
        }
        (lower + upper) * double(0.5)
    }
}

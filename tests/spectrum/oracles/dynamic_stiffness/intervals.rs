//! Whether certified intervals hold their natural frequencies: by the counts at both of their ends.

use super::{Stiffness, Verdict};
use mstmm::number::DoubleDouble;
use mstmm::search::NaturalFrequency;

/// A step outwards, much less than anything that an `f64` resolves: a frequency on an end of its interval is in it.
const OUTWARDS: f64 = 1e-24;

/// Doublings of an interval after which a frequency is somewhere else.
const DOUBLINGS: i32 = 60;

impl Stiffness {
    /// Number of frequencies below a point that is moved by a small part of itself.
    fn count_beside(&self, omega: DoubleDouble, part: f64) -> Option<u64> {
        self.count_below(omega * DoubleDouble::from_sum(1.0, part))
    }

    /// Number of frequencies below ω, at a point where no rounding can change it; `None` if there is a frequency.
    pub(crate) fn sure_count(&self, omega: f64) -> Option<u64> {
        let ends = [-1.0, 1.0].map(|sign| self.count_beside(DoubleDouble::from(omega), sign * 4.0 * f64::EPSILON));
        if ends[0] == ends[1] { ends[0] } else { None }
    }

    /// Number of frequencies below the upper end of an interval. Just above zero, stiffnesses hide what mass adds to
    /// them: there, a larger frequency is as good, if it is far below the next.
    fn count_up_to(&self, upper: f64, next: f64) -> Option<u64> {
        let mut omega = upper;
        loop {
            let count = self.count_beside(DoubleDouble::from(omega), OUTWARDS);
            if count.is_some() || omega > 1e-6 * next {
                return count;
            }
            omega *= 4.0;
        }
    }

    /// Whether the frequencies from number `below` on, `multiplicity` of them, are between two points.
    fn are_between(&self, lower: f64, upper: f64, next: f64, below: u64, multiplicity: u64) -> Option<bool> {
        let before = match lower > 0.0 {
            true => self.count_beside(DoubleDouble::from(lower), -OUTWARDS)?,
            false => 0,
        };
        Some(before <= below && self.count_up_to(upper, next)? >= below + multiplicity)
    }

    /// Whether each interval of a list that starts behind `below` frequencies holds its own.
    pub(crate) fn judge_intervals(&self, list: &[NaturalFrequency], mut below: u64) -> Vec<Verdict> {
        let mut verdicts = Vec::new();
        for (index, root) in list.iter().enumerate() {
            let next = list.get(index + 1).map_or(0.0, |next| next.lower);
            let are_between = |lower, upper| self.are_between(lower, upper, next, below, root.multiplicity);
            let half = (root.upper - root.lower) / 2.0;
            verdicts.push(match are_between(root.lower, root.upper) {
                None => Verdict::CannotTell,
                Some(true) => Verdict::Holds,
                Some(false) => {
                    let wider = |k: &i32| {
                        let distance = half * 2f64.powi(*k);
                        are_between(root.omega - distance, root.omega + distance) == Some(true)
                    };
                    Verdict::Misses((1..DOUBLINGS).find(wider).map_or(f64::INFINITY, |k| 2f64.powi(k)))
                }
            });
            below += root.multiplicity;
        }
        verdicts
    }
}

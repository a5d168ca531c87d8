//! Certificates: an interval holds the frequencies from one index on, so many of them.
//!
//! `J(lower) <= k - 1`, bounded from above, and `J(upper) >= k + m - 1`, bounded from below, are the statement that the frequencies k to
//! k + m - 1 lie in `[lower, upper)`. Nothing else is in a certificate, and nothing that proposed it has to be trusted.

use crate::number::Real;
use crate::proof::beside::{Beside, Evidence};
use crate::proof::count::Side;
use crate::proof::prover::{Bound, Precision, Prover, share_of, zero_of};

/// Half widths of the intervals that are claimed where two neighbouring numbers fail, in units of eps.
const WIDER: [f64; 3] = [4.0, 16.0, 32.0];

/// Frequencies of an interval that is proven.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Proven<T> {
    /// The end that is nearer to the zero of Δ; of several frequencies either.
    pub(crate) omega: T,
    pub(crate) lower: T,
    pub(crate) upper: T,
    /// The index of the first frequency, from 1 on.
    pub(crate) index: u64,
    pub(crate) multiplicity: u64,
    /// Whether a bound at `lower` is proven. Else a bound at `upper` alone is: the entry before holds some of these frequencies.
    pub(crate) is_apart: bool,
}

/// What comes of a claim.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Claim<T> {
    /// It is proven.
    Proven(Proven<T>),
    /// The frequency of that index is proven to be below this.
    Below(T),
    /// It is proven to be at this or above.
    Above(T),
    /// Rounding decides it even in four words.
    Undecided,
}

impl Prover<'_> {
    /// Claims that the frequency of an index is beside an estimate, and at `floor` or above, by what two words tell beside it.
    pub(crate) fn claim<T: Real>(&mut self, index: u64, mut evidence: Evidence<T>, floor: T) -> Claim<T> {
        for precision in [Precision::Two, Precision::Four] {
            if precision == Precision::Four {
                if self.is_beyond() {
                    break;
                }
                evidence = Beside::of(self, &[evidence.omega()], precision).found[0];
            }
            let (omega, Evidence { mut ends, mut bounds, .. }) = (evidence.omega(), evidence);
            if ends[0] < floor {
                ends[0] = floor;
                bounds[0] = self.bound(floor, Side::AtMost, precision);
            }
            if ends[0] < ends[1] {
                if let Some(proven) = proven(index, ends, bounds) {
                    return Claim::Proven(proven);
                }
                if bounds[0].count.is_none_or(|below| below >= index)
                    && self.bound(ends[0], Side::AtLeast, precision).count.is_some_and(|below| below >= index)
                {
                    return Claim::Below(ends[0]);
                }
                if bounds[1].count.is_none_or(|below| below < index)
                    && self.bound(ends[1], Side::AtMost, precision).count.is_some_and(|below| below < index)
                {
                    return Claim::Above(ends[1]);
                }
            }
            for half in WIDER {
                let away = omega * T::from_f64(half * T::EPSILON);
                let ends = [or_floor(omega - away, floor), omega + away];
                let bounds =
                    [self.bound(ends[0], Side::AtMost, precision), self.bound(ends[1], Side::AtLeast, precision)];
                if let Some(proven) = proven(index, ends, bounds) {
                    return Claim::Proven(proven);
                }
            }
        }
        Claim::Undecided
    }
}

/// What is proven by the bounds at both ends.
fn proven<T: Real>(index: u64, ends: [T; 2], bounds: [Bound; 2]) -> Option<Proven<T>> {
    let [most, least] = bounds.map(|bound| bound.count);
    let (most, least) = (most?, least?);
    let [lower, upper] = ends;
    let omega = if upper > lower.next_above() {
        let zero = zero_of(ends, bounds);
        if lower <= zero && zero <= upper { zero } else { lower + (upper - lower) * T::from_f64(0.5) }
    } else if share_of(bounds) < 0.5 {
        lower
    } else {
        upper
    };
    let multiplicity = least.saturating_sub(index - 1);
    (most < index && least >= index).then_some(Proven { omega, lower, upper, index, multiplicity, is_apart: true })
}

/// An end that is no lower than another interval's upper end.
fn or_floor<T: Real>(lower: T, floor: T) -> T {
    if lower < floor { floor } else { lower }
}

//! Bisection by proven counts: what finds a frequency that nobody has proposed, or refuses with numbers.

use crate::number::Real;
use crate::proof::beside::Beside;
use crate::proof::certificate::{Claim, Proven};
use crate::proof::count::Side;
use crate::proof::prover::{Bound, Precision, Prover, zero_of};

/// Steps of a bisection: the exponents of a word, and then its bits, with a step of the secant method between every two.
const STEPS: usize = 256;

/// Width of an interval, in units of eps, that is a certificate although rounding decides what is inside.
const WIDEST: f64 = 64.0;

/// Factor between frequencies at which an upper end is sought.
const FACTOR: f64 = 4.0;

/// What was not found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Refusal {
    /// Rounding decides a count even in four words.
    Undecided {
        /// The frequency.
        near: f64,
    },
    /// So many frequencies are below the limit of the search, and no more.
    Fewer(u64),
}

/// Where a frequency lies, beside another one.
enum Place {
    Below(Bound),
    AtOrAbove(Bound),
    Unknown,
}

impl Prover<'_> {
    /// On which side of ω the frequency of an index lies.
    fn place<T: Real>(&mut self, index: u64, omega: T) -> Place {
        for precision in [Precision::Two, Precision::Four] {
            let most = self.bound_at(omega, 1.0, Side::AtMost, precision);
            if self.is_beyond() {
                break;
            }
            if most.count.is_some_and(|count| count < index) {
                return Place::AtOrAbove(most);
            }
            let least = self.bound_at(omega, 1.0, Side::AtLeast, precision);
            if least.count.is_some_and(|count| count >= index) {
                return Place::Below(least);
            }
        }
        Place::Unknown
    }

    /// The frequency of an index, sought from `lower` on, where `index - 1` are known to be below at least, and from a guess on up to a limit.
    pub(crate) fn bisected<T: Real>(&mut self, index: u64, lower: T, guess: T, limit: T) -> Result<Proven<T>, Refusal> {
        let (mut lower, mut upper) = ((lower, None), (guess, None));
        for _ in 0..STEPS {
            match self.place(index, upper.0) {
                Place::Below(bound) => {
                    upper.1 = Some(bound);
                    break;
                }
                Place::AtOrAbove(bound) => {
                    lower = (upper.0, Some(bound));
                    if upper.0 >= limit {
                        return Err(bound.count.map_or(refused(upper.0), Refusal::Fewer));
                    }
                    let next = upper.0 * T::from_f64(FACTOR);
                    upper.0 = if next < limit { next } else { limit };
                }
                Place::Unknown if self.is_beyond() => break,
                // another frequency is there
                Place::Unknown => upper.0 *= T::from_f64(1.0 + 1e-3),
            }
        }
        if upper.1.is_none() {
            return Err(refused(upper.0));
        }
        self.between(index, lower, upper)
    }

    /// The frequency of an index between two proven ends.
    fn between<T: Real>(
        &mut self,
        index: u64,
        mut lower: (T, Option<Bound>),
        mut upper: (T, Option<Bound>),
    ) -> Result<Proven<T>, Refusal> {
        for step in 0..STEPS {
            let middle = middle(lower.0, upper.0);
            if !(lower.0 < middle && middle < upper.0) {
                break;
            }
            if let (Some(below), Some(above), true) = (lower.1, upper.1, step % 2 == 1)
                && upper.0 < lower.0 * T::from_f64(2.0)
            {
                let zero = zero_of([lower.0, upper.0], [below, above]);
                if lower.0 < zero && zero < upper.0 {
                    let beside = Beside::of(self, &[zero], Precision::Two);
                    match self.claim(index, beside.found[0], lower.0) {
                        Claim::Proven(proven) => return Ok(proven),
                        Claim::Below(end) if lower.0 < end && end < upper.0 => upper = (end, None),
                        Claim::Above(end) if lower.0 < end && end < upper.0 => lower = (end, None),
                        _ => {}
                    }
                }
            }
            let middle = self::middle(lower.0, upper.0);
            match self.place(index, middle) {
                Place::Below(bound) => upper = (middle, Some(bound)),
                Place::AtOrAbove(bound) => lower = (middle, Some(bound)),
                Place::Unknown => break,
            }
        }
        let (lower, upper) = (lower.0, upper.0);
        let count = self.bounds(upper, 1.0)[0].unwrap_or(0);
        // the lower end may be the caller's, of which a count from below is known and none from above
        let is_apart = self.bounds(lower, 1.0)[1].is_some_and(|most| most < index);
        if upper - lower > upper * T::from_f64(WIDEST * T::EPSILON) || count < index {
            return Err(refused(middle(lower, upper)));
        }
        Ok(Proven { omega: middle(lower, upper), lower, upper, index, multiplicity: count - (index - 1), is_apart })
    }
}

/// A refusal near a frequency.
fn refused<T: Real>(near: T) -> Refusal {
    Refusal::Undecided { near: near.to_f64() }
}

/// The middle between two frequencies, far apart that of their exponents.
fn middle<T: Real>(lower: T, upper: T) -> T {
    if upper < lower * T::from_f64(4.0) {
        return lower + (upper - lower) * T::from_f64(0.5);
    }
    if lower > T::zero() { lower.sqrt() * upper.sqrt() } else { upper * T::from_f64(1e-6) }
}

//! Certificates: an interval holds the frequencies from one index on, so many of them.
//!
//! `J(lower) <= k - 1`, bounded from above, and `J(upper) >= k + m - 1`, bounded from below, are the statement that the frequencies k to
//! k + m - 1 lie in `[lower, upper)`. Nothing else is in a certificate, and nothing that proposed it has to be trusted.

use crate::model::Spot;
use crate::number::{Real, Scalar};
use crate::proof::beside::{Beside, Evidence};
use crate::proof::count::{At, Outcome, Place, Side};
use crate::proof::four_words::FourWords;
use crate::proof::joining::Failure;
use crate::proof::memory::Memory;
use crate::proof::number::TwoWords;
use crate::proof::visit::Visited;

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

/// The precision of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Precision {
    /// Two words.
    Two,
    /// Four words.
    Four,
}

/// A bound of a count with Δ.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bound {
    /// The bound; none where nothing is known.
    pub(crate) count: Option<u64>,
    /// The bound as it was found: of a model in which something is held twice one from below may be negative.
    found: f64,
    value: f64,
    exponent: i64,
}

impl Bound {
    /// Nothing is known.
    pub(crate) const UNKNOWN: Self = Bound { count: None, found: f64::NAN, value: f64::NAN, exponent: 0 };
}

/// A frequency at which a bound of the count is wanted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point<T> {
    pub(crate) omega: T,
    pub(crate) side: Side,
}

/// What proves claims about a model.
pub(crate) struct Prover<'a> {
    model: &'a dyn Visited,
    memory: Memory,
    /// Runs so far, in two words and in four.
    pub(crate) runs: usize,
    pub(crate) long_runs: usize,
    /// Why the last run told nothing; none where it told something.
    pub(crate) failure: Option<Failure>,
    /// The node or the step of the smallest pivot of the last run.
    pub(crate) smallest_at: usize,
}

impl<'a> Prover<'a> {
    /// What proves claims about a model.
    pub(crate) fn new(model: &'a dyn Visited) -> Self {
        Prover { model, memory: Memory::default(), runs: 0, long_runs: 0, failure: None, smallest_at: 0 }
    }

    /// What a node or a step is called.
    pub(crate) fn spot(&self, place: usize) -> Spot {
        self.model.spot(place)
    }

    /// A bound of the count at `sign ω²`.
    pub(crate) fn bound_at<T: Real>(&mut self, omega: T, sign: f64, side: Side, precision: Precision) -> Bound {
        self.run(omega.words(), sign, side, precision)
    }

    /// A run at the sum of two words; not generic, so that it is compiled here once and not in each crate that searches.
    fn run(&mut self, omega: [f64; 2], sign: f64, side: Side, precision: Precision) -> Bound {
        let place = [(omega, side)];
        let outcome = match precision {
            Precision::Two => {
                self.runs += 1;
                match self.memory.run_in_lanes(self.model, &place, sign) {
                    Some((outcomes, _)) => Ok(outcomes[0]),
                    None => self.memory.run::<TwoWords<f64>>(self.model, At::new(&place, sign)),
                }
            }
            Precision::Four => {
                self.long_runs += 1;
                self.memory.run::<FourWords>(self.model, At::new(&place, sign))
            }
        };
        self.bound_of(side, outcome)
    }

    /// Runs at some places, in lanes where the machine has them: the bound of each is put in its slot.
    fn run_all(&mut self, places: &[Place], slots: &[usize], precision: Precision, bounds: &mut [Bound]) {
        let mut from = 0;
        while from < places.len() {
            let rest = &places[from..];
            let outcomes = match precision {
                Precision::Two if rest.len() > 1 => self.memory.run_in_lanes(self.model, rest, 1.0),
                _ => None,
            };
            let Some((outcomes, count)) = outcomes else {
                let (omega, side) = rest[0];
                bounds[slots[from]] = self.run(omega, 1.0, side, precision);
                from += 1;
                continue;
            };
            self.runs += count;
            for ((_, side), outcome) in rest.iter().zip(outcomes).take(count) {
                bounds[slots[from]] = self.bound_of(*side, Ok(outcome));
                from += 1;
            }
        }
    }

    /// The bound that a run tells.
    fn bound_of(&mut self, side: Side, outcome: Result<Outcome<f64>, Failure>) -> Bound {
        match outcome {
            Ok(Outcome { count, value, exponent, smallest_at }) => {
                (self.smallest_at, self.failure) = (smallest_at, None);
                // a lower bound may be negative, and says nothing then; an upper one is not, unless no model has it
                let found = count;
                let count = if side == Side::AtLeast { count.max(0.0) } else { count };
                Bound { count: (count >= 0.0).then_some(count as u64), found, value, exponent }
            }
            Err(failure) => {
                self.failure = Some(failure);
                Bound::UNKNOWN
            }
        }
    }

    /// Bounds at as many points as there are.
    pub(crate) fn bounds_at<T: Real, const P: usize>(
        &mut self,
        points: &[Option<Point<T>>; P],
        precision: Precision,
        bounds: &mut [Bound; P],
    ) {
        let (mut places, mut slots, mut count) = ([([0.0; 2], Side::AtMost); P], [0; P], 0);
        for (slot, point) in points.iter().enumerate() {
            if let Some(Point { omega, side }) = point {
                (places[count], slots[count]) = ((omega.words(), *side), slot);
                count += 1;
            }
        }
        self.run_all(&places[..count], &slots[..count], precision, bounds);
    }

    /// A bound of the number of frequencies below ω.
    fn bound<T: Real>(&mut self, omega: T, side: Side, precision: Precision) -> Bound {
        self.bound_at(omega, 1.0, side, precision)
    }

    /// Both bounds of the count at `sign ω²`, in four words where two do not decide it.
    pub(crate) fn bounds<T: Real>(&mut self, omega: T, sign: f64) -> [Option<u64>; 2] {
        self.bounds_with_delta(omega, sign).0
    }

    /// Both bounds of the count, and the last one from above, which has Δ.
    pub(crate) fn bounds_with_delta<T: Real>(&mut self, omega: T, sign: f64) -> ([Option<u64>; 2], Bound) {
        let both_in = |prover: &mut Self, precision| {
            [Side::AtLeast, Side::AtMost].map(|side| prover.bound_at(omega, sign, side, precision))
        };
        let [least, most] = both_in(self, Precision::Two);
        let both = [least.count, most.count];
        if self.is_beyond() || both[0].is_some() && both[0] == both[1] {
            return (both, most);
        }
        let [least, most] = both_in(self, Precision::Four);
        ([both[0].max(least.count), both[1].into_iter().chain(most.count).min()], most)
    }

    /// Whether the last run told nothing for a reason that more digits do not remove.
    pub(crate) fn is_beyond(&self) -> bool {
        matches!(self.failure, Some(Failure::Full | Failure::NotInNumbers | Failure::NotEnclosed))
    }

    /// Whether both bounds of the count at ω differ, or one is lost, in two words.
    pub(crate) fn is_open<T: Real>(&mut self, omega: T) -> bool {
        let [least, most] = [Side::AtLeast, Side::AtMost].map(|side| self.bound_at(omega, 1.0, side, Precision::Two));
        least.found != most.found
    }

    /// The count at `sign ω²`, where both bounds agree.
    pub(crate) fn count<T: Real>(&mut self, omega: T, sign: f64) -> Result<u64, [Option<u64>; 2]> {
        match self.bounds(omega, sign) {
            [Some(least), Some(most)] if least == most => Ok(least),
            bounds => Err(bounds),
        }
    }

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

/// The zero of the chord of Δ, as a share of the distance of both ends.
pub(crate) fn share_of([lower, upper]: [Bound; 2]) -> f64 {
    let shift = (upper.exponent - lower.exponent).clamp(-2000, 2000) as i32;
    let other = upper.value.times_power_of_two(shift);
    lower.value / (lower.value - other)
}

/// The zero of the chord of Δ, or the middle where there is none.
pub(crate) fn zero_of<T: Real>([lower, upper]: [T; 2], bounds: [Bound; 2]) -> T {
    let share = share_of(bounds);
    let share = if share.is_finite() { share.clamp(-1e9, 1e9) } else { 0.5 };
    lower + (upper - lower) * T::from_f64(share)
}

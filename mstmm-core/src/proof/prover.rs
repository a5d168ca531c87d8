//! What proves claims about a model: bounds of its count, in two words and in four, in lanes where the machine has them.

use crate::model::Spot;
use crate::number::{Real, Scalar};
use crate::proof::count::{Outcome, Place, Side};
use crate::proof::four_words::FourWords;
use crate::proof::join::Failure;
use crate::proof::memory::{Memory, Question};
use crate::proof::number::TwoWords;
use crate::proof::visit::Visited;
use crate::proof::word::MOST_LANES;

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
        self.run((omega.words(), side), sign, precision)
    }

    /// A run at a place.
    fn run(&mut self, place: Place, sign: f64, precision: Precision) -> Bound {
        let mut bound = [Bound::UNKNOWN];
        self.run_all(&[place], &[0], sign, precision, &mut bound);
        bound[0]
    }

    /// Runs at some places, in lanes where the machine has them: the bound of each is put in its slot. It is not generic, so that runs are compiled here
    /// once and not in each crate that searches.
    fn run_all(&mut self, places: &[Place], slots: &[usize], sign: f64, precision: Precision, bounds: &mut [Bound]) {
        let mut from = 0;
        while from < places.len() {
            let question = Question { model: self.model, places: &places[from..], sign };
            let alone = Question { places: &places[from..=from], ..question };
            let outcomes = match precision {
                Precision::Two => match self.memory.run_in_lanes(question) {
                    Some(outcomes) => Ok(outcomes),
                    None => self.memory.run::<TwoWords<f64>>(alone).map(|outcomes| (outcomes, 1)),
                },
                Precision::Four => self.memory.run::<FourWords>(alone).map(|outcomes| (outcomes, 1)),
            };
            let (outcomes, count) = match outcomes {
                Ok((outcomes, count)) => (outcomes.map(Some), count),
                Err(failure) => {
                    self.failure = Some(failure);
                    ([None; MOST_LANES], 1)
                }
            };
            match precision {
                Precision::Two => self.runs += count,
                Precision::Four => self.long_runs += count,
            }
            for (outcome, (_, side)) in outcomes.into_iter().zip(&places[from..from + count]) {
                bounds[slots[from]] = outcome.map_or(Bound::UNKNOWN, |outcome| self.bound_of(*side, outcome));
                from += 1;
            }
        }
    }

    /// The bound that a run tells.
    fn bound_of(&mut self, side: Side, outcome: Outcome) -> Bound {
        let Outcome { count: found, value, exponent, smallest_at } = outcome;
        (self.smallest_at, self.failure) = (smallest_at, None);
        // a lower bound may be negative, and says nothing then; an upper one is not, unless no model has it
        let count = if side == Side::AtLeast { found.max(0.0) } else { found };
        Bound { count: (count >= 0.0).then_some(count as u64), found, value, exponent }
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
        self.run_all(&places[..count], &slots[..count], 1.0, precision, bounds);
    }

    /// A bound of the number of frequencies below ω.
    pub(crate) fn bound<T: Real>(&mut self, omega: T, side: Side, precision: Precision) -> Bound {
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

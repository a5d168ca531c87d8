//! Bounds of the number of natural frequencies below a frequency: one run through the model.

use crate::proof::ball::Ball;
use crate::proof::front::{Front, Total, Variable};
use crate::proof::join::Failure;
use crate::proof::joining::Joining;
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::run::join_all;
use crate::proof::tree::Path;
use crate::proof::visit::Visited;
use crate::proof::word::{MOST_LANES, Word, load};
use core::array::from_fn;

/// Which bound of a count is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// At most so many frequencies are below.
    AtMost,
    /// At least so many are.
    AtLeast,
}

impl Side {
    /// The direction in which pivots are moved.
    pub(crate) fn toward(self) -> f64 {
        match self {
            Side::AtMost => -1.0,
            Side::AtLeast => 1.0,
        }
    }
}

/// What a run tells of a lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    /// The bound; NaN where it was lost.
    pub(crate) count: f64,
    /// Δ over `2^exponent` and over powers of two that are the same in all lanes: it decides nothing.
    pub(crate) value: f64,
    pub(crate) exponent: i64,
    /// The node or the step of the pivot that is smallest beside the terms of its entry, in the first lane.
    pub(crate) smallest_at: usize,
}

/// What a run tells of as many lanes as it had; nothing is said of others.
pub(crate) type Outcomes = [Outcome; MOST_LANES];

/// Memory for a run.
pub(crate) struct Room<'m, N: Level> {
    pub(crate) entries: &'m mut [N],
    pub(crate) variables: &'m mut [Variable<N::Word>],
    pub(crate) paths: &'m mut [Path<N::Alone>],
}

/// A run at ω², of either sign, in memory for a front.
#[inline(always)]
pub(crate) fn run<'m, N: Level>(model: &'m dyn Visited, memory: Room<'m, N>, at: At<N>) -> Result<Outcomes, Failure> {
    let At { square, toward, omega, known_at } = at;
    let front = Front::new(memory.entries, memory.variables, toward);
    let known_at = (N::Word::LANES == 1).then_some(known_at);
    let mut joining = join_all(model, known_at, Joining::new(front, [square, omega]), memory.paths);
    joining.leave_all();
    let Joining { front, held, failure, .. } = joining;
    if let Some(failure) = failure {
        return Err(failure);
    }
    let total = front.total;
    let (mut counts, mut values) = ([0.0; MOST_LANES], [0.0; MOST_LANES]);
    (total.negative + held).store(&mut counts);
    total.product.store(&mut values);
    let Total { exponent, smallest_at, .. } = total;
    Ok(from_fn(|lane| Outcome { count: counts[lane], value: values[lane], exponent, smallest_at }))
}

/// Where a bound is wanted, at a frequency that is the sum of two words, and which one.
pub(crate) type Place = ([f64; 2], Side);

/// Where a run is made, and to which side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct At<N: Number> {
    /// ω², of either sign.
    square: Ball<N>,
    /// -1 for a bound from above, 1 for one from below.
    toward: N::Word,
    /// ω; 0 where ω² is negative.
    omega: Ball<N>,
    /// ω of the first lane as the sum of two words.
    known_at: [f64; 2],
}

impl<N: Level> At<N> {
    /// At `sign ω²`, a place in each lane.
    #[inline(always)]
    pub(crate) fn new(places: &[Place], sign: f64) -> Self {
        let real = |omega: [f64; 2]| if sign < 0.0 { [0.0; 2] } else { omega };
        At {
            square: Ball::of_lanes(places, &|(omega, _)| signed_square(*omega, sign)),
            toward: load(places, &|(_, side)| side.toward()),
            omega: Ball::of_lanes(places, &|(omega, _)| Ball::of_pair(real(*omega))),
            known_at: places.first().map_or([0.0; 2], |(omega, _)| real(*omega)),
        }
    }
}

/// ω², of the sign of ω, of a frequency that is the sum of two words.
fn signed_square<A: Level<Word = f64>>([hi, lo]: [f64; 2], sign: f64) -> Ball<A> {
    let square = if lo == 0.0 {
        Ball::of_product(hi, hi)
    } else {
        let omega = Ball::exactly(A::of_word(hi).plus(A::of_word(lo)));
        omega * omega
    };
    square.scaled(sign)
}

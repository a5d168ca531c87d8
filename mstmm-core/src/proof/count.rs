//! Bounds of the number of natural frequencies below a frequency: one run through the model.

use crate::element::{Exact, MemberNumbers, OwnPart};
use crate::proof::ball::Ball;
use crate::proof::frame::Nodes;
use crate::proof::front::{Front, Total, Variable};
use crate::proof::joining::{Failure, Joining};
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::tree::{Path, Paths};
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use crate::proof::word::{MOST_LANES, Word, load};
use core::array::from_fn;
use mstmm_plan::{Freedoms, Space, Support};

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

/// A run in progress.
struct Run<'m, N: Level> {
    model: &'m dyn Visited,
    /// The frequency, as the sum of two words.
    omega: [f64; 2],
    joining: Joining<'m, N>,
    paths: Paths<'m, N::Alone>,
    nodes: Nodes,
}

impl<N: Level> Run<'_, N> {
    /// An element that is not known in numbers, which is known at one frequency.
    fn own_part(&self, place: usize, numbers: &MemberNumbers) -> Option<OwnPart> {
        match numbers {
            MemberNumbers::Other if N::Word::LANES == 1 => self.model.own_part(place, self.omega),
            _ => None,
        }
    }
}

impl<N: Level> Visitor for Run<'_, N> {
    fn tip(&mut self, step: usize, support: Support) {
        self.paths.tip(step, support, &mut self.joining);
    }

    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers) {
        self.joining.front.total.place = step;
        if self.joining.failure.is_none() {
            let own = self.own_part(step, numbers);
            self.paths.element([step, input], space, (numbers, own), &mut self.joining);
        }
    }

    fn connection(&mut self, step: usize, inputs: &[usize], output: Option<Space>) {
        self.joining.front.total.place = step;
        if self.joining.failure.is_none() {
            self.paths.connection(step, inputs, output, &mut self.joining);
        }
    }

    fn root(&mut self, input: usize, support: Support) {
        self.joining.front.total.place = input;
        if self.joining.failure.is_none() {
            self.paths.root(input, support, &mut self.joining);
        }
    }

    fn member(&mut self, member: (usize, Freedoms), numbers: &MemberNumbers, ends: &[MemberEnd; 2], next: usize) {
        if self.joining.failure.is_none() {
            let own = self.own_part(member.0, numbers);
            self.nodes.member((numbers, own, member.1), ends, next, &mut self.joining);
        }
    }

    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: Exact, centre: [Exact; 2]) {
        if self.joining.failure.is_none() {
            self.nodes.body(node, [mass, inertia], centre, &mut self.joining);
        }
    }

    fn leave(&mut self, node: usize) {
        self.joining.front.total.place = node;
        if self.joining.failure.is_none() {
            self.nodes.leave(node, &mut self.joining);
        }
    }
}

/// Memory for a run.
pub(crate) struct Room<'m, N: Level> {
    pub(crate) entries: &'m mut [N],
    pub(crate) variables: &'m mut [Variable<N::Word>],
    pub(crate) paths: &'m mut [Path<N::Alone>],
}

/// A run at ω², of either sign, in memory for a front.
#[inline(always)]
pub(crate) fn run<'m, N: Level>(model: &'m dyn Visited, memory: Room<'m, N>, at: At<N>) -> Result<Outcomes, Failure> {
    let At { square, toward, omega } = at;
    let front = Front::new(memory.entries, memory.variables, toward);
    let mut run = Run {
        model,
        omega,
        joining: Joining::new(front, square),
        paths: Paths::new(memory.paths),
        nodes: Nodes::new(),
    };
    model.visit(&mut run);
    run.joining.leave_all();
    let Joining { front, held, failure, .. } = run.joining;
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
    /// ω of the first lane as the sum of two words; 0 where ω² is negative.
    omega: [f64; 2],
}

impl<N: Level> At<N> {
    /// At `sign ω²`, a place in each lane.
    #[inline(always)]
    pub(crate) fn new(places: &[Place], sign: f64) -> Self {
        let omega = places.first().map_or([0.0; 2], |(omega, _)| if sign < 0.0 { [0.0; 2] } else { *omega });
        At {
            square: Ball::of_lanes(places, &|(omega, _)| signed_square(*omega, sign)),
            toward: load(places, &|(_, side)| side.toward()),
            omega,
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

//! Bounds of the number of natural frequencies below a frequency: one run through the model.

use crate::element::{Exact, MemberNumbers};
use crate::proof::ball::Ball;
use crate::proof::frame::Nodes;
use crate::proof::front::{Front, Variable};
use crate::proof::functions::Level;
use crate::proof::joining::{Failure, Joining};
use crate::proof::number::Number;
use crate::proof::tree::{Path, Paths};
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use crate::proof::word::{MOST_LANES, Word, load};
use core::array::from_fn;
use mstmm_plan::{Space, Support};

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

/// What a run tells, a number in each lane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome<W> {
    /// The bound; NaN where it was lost.
    pub(crate) count: W,
    /// Δ over `2^exponent` and over powers of two that are the same in all lanes: it decides nothing.
    pub(crate) value: W,
    pub(crate) exponent: i64,
    /// The node or the step of the pivot that is smallest beside the terms of its entry, in the first lane.
    pub(crate) smallest_at: usize,
}

/// A run in progress.
struct Run<'m, N: Level> {
    model: &'m dyn Visited,
    /// The frequency, as the sum of two words.
    omega: [f64; 2],
    joining: Joining<'m, N>,
    paths: Paths<'m, N::Alone>,
    nodes: Nodes,
}

impl<N: Level> Visitor for Run<'_, N> {
    fn tip(&mut self, step: usize, support: Support) {
        self.paths.tip(step, support, &mut self.joining);
    }

    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers) {
        self.joining.front.total.place = step;
        if self.joining.failure.is_none() {
            // an element that is not known in numbers is known at one frequency
            let own = match numbers {
                MemberNumbers::Other if N::Word::LANES == 1 => self.model.own_part(step, self.omega),
                _ => None,
            };
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

    fn member(&mut self, numbers: &MemberNumbers, ends: &[MemberEnd; 2], next: usize) {
        if self.joining.failure.is_none() {
            self.nodes.member(numbers, ends, next, &mut self.joining);
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
struct Room<'m, N: Level> {
    entries: &'m mut [N],
    variables: &'m mut [Variable<N::Word>],
    paths: &'m mut [Path<N::Alone>],
}

/// A run at ω², of either sign, in memory for a front.
#[inline(always)]
fn run<'m, N: Level>(model: &'m dyn Visited, memory: Room<'m, N>, at: At<N>) -> Result<Outcome<N::Word>, Failure> {
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
    let Joining { front, held, failure, .. } = run.joining;
    if let Some(failure) = failure {
        return Err(failure);
    }
    let total = front.total;
    Ok(Outcome {
        count: total.negative + held,
        value: total.product,
        exponent: total.exponent,
        smallest_at: total.smallest_at,
    })
}

/// Runs in memory for as many variables as the model has at once.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Memory {
    /// Index of the smallest memory that may do.
    class: usize,
}

impl Memory {
    /// A run; where the front has no room it is made again with more.
    pub(crate) fn run<N: Level<Word = f64>>(
        &mut self,
        model: &dyn Visited,
        at: At<N>,
    ) -> Result<Outcome<f64>, Failure> {
        loop {
            let outcome = match self.class {
                0 => on_stack::<N, 6, 21, 4>(model, at),
                1 => on_stack::<N, 12, 78, 12>(model, at),
                2 => on_stack::<N, 24, 300, 24>(model, at),
                3 => on_stack::<N, 64, 2080, 64>(model, at),
                class => return beyond_stack(class, model, at),
            };
            match outcome {
                Err(Failure::Full) => self.class += 1,
                outcome => return outcome,
            }
        }
    }

    /// Runs in two words at some points, in the lanes of the machine; none where it has no lanes, or too little memory for as many.
    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    pub(crate) fn run_in_lanes(&mut self, model: &dyn Visited, points: &[Place], sign: f64) -> Option<Outcomes> {
        use mstmm_lanes::{Eight, Four, InstructionSet, Lanes};
        match InstructionSet::in_use() {
            InstructionSet::Target => None,
            InstructionSet::Avx512 if points.len() > 4 => self.in_lanes::<Lanes<Eight>>(model, points, sign),
            _ => self.in_lanes::<Lanes<Four>>(model, points, sign),
        }
    }

    /// The same in lanes of a word.
    #[cfg(all(feature = "std", target_arch = "x86_64", not(debug_assertions)))]
    fn in_lanes<W: Word>(&mut self, model: &dyn Visited, points: &[Place], sign: f64) -> Option<Outcomes> {
        let points = &points[..points.len().min(W::LANES)];
        loop {
            let at = At::<crate::proof::number::TwoWords<W>>::new(points, sign);
            let outcome = match self.class {
                0 => on_stack::<_, 6, 21, 4>(model, at),
                1 => on_stack::<_, 12, 78, 12>(model, at),
                2 => on_stack::<_, 24, 300, 24>(model, at),
                _ => return None,
            };
            match outcome {
                Err(Failure::Full) => self.class += 1,
                outcome => return outcome.ok().map(|outcome| outcome.lanes(points.len())),
            }
        }
    }

    /// Where nothing stands in lanes.
    #[cfg(not(all(feature = "std", target_arch = "x86_64", not(debug_assertions))))]
    pub(crate) fn run_in_lanes(&mut self, _: &dyn Visited, _: &[Place], _: f64) -> Option<Outcomes> {
        None
    }
}

/// The outcomes of lanes.
pub(crate) type Outcomes = ([Outcome<f64>; MOST_LANES], usize);

impl<W: Word> Outcome<W> {
    /// The outcomes of so many lanes.
    #[cfg_attr(debug_assertions, expect(dead_code, reason = "there are no lanes"))]
    fn lanes(self, lanes: usize) -> Outcomes {
        let (mut counts, mut values) = ([0.0; MOST_LANES], [0.0; MOST_LANES]);
        self.count.store(&mut counts);
        self.value.store(&mut values);
        (from_fn(|lane| Outcome { count: counts[lane], value: values[lane], ..self.first() }), lanes)
    }

    /// The outcome of the first lane.
    fn first(self) -> Outcome<f64> {
        let Outcome { count, value, exponent, smallest_at } = self;
        Outcome { count: count.first(), value: value.first(), exponent, smallest_at }
    }
}

/// A run in memory for up to `W` variables with `E = W (W + 1)/2` entries, and for up to `P` open paths.
#[inline(never)]
fn on_stack<N: Level, const W: usize, const E: usize, const P: usize>(
    model: &dyn Visited,
    at: At<N>,
) -> Result<Outcome<N::Word>, Failure> {
    let (mut entries, mut variables, mut paths) = ([N::of(0.0); E], [Variable::none(); W], [Path::none(); P]);
    run(model, Room { entries: &mut entries, variables: &mut variables, paths: &mut paths }, at)
}

/// A run for a front that is too wide for the stack.
#[cfg(feature = "std")]
#[inline(never)]
fn beyond_stack<N: Level<Word = f64>>(_class: usize, model: &dyn Visited, at: At<N>) -> Result<Outcome<f64>, Failure> {
    /// Variables of the widest front.
    const WIDEST: usize = 512;
    let mut entries = std::vec![N::of(0.0); WIDEST * (WIDEST + 1) / 2];
    let mut variables = std::vec![Variable::none(); WIDEST];
    let mut paths = std::vec![Path::none(); WIDEST];
    run(model, Room { entries: &mut entries, variables: &mut variables, paths: &mut paths }, at)
}

/// Without `std` there is no memory but the stack.
#[cfg(not(feature = "std"))]
fn beyond_stack<N: Level<Word = f64>>(
    _class: usize,
    _model: &dyn Visited,
    _at: At<N>,
) -> Result<Outcome<f64>, Failure> {
    Err(Failure::Full)
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

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
use crate::proof::word::Word;
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
struct Run<'m, N: Number> {
    model: &'m dyn Visited,
    /// The frequency, as the sum of two words.
    omega: [f64; 2],
    joining: Joining<'m, N>,
    paths: Paths<'m, N>,
    nodes: Nodes,
}

impl<N: Level> Visitor for Run<'_, N> {
    fn tip(&mut self, step: usize, support: Support) {
        self.paths.tip(step, support, &mut self.joining);
    }

    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers) {
        self.joining.front.total.place = step;
        if self.joining.failure.is_none() {
            let own = match numbers {
                MemberNumbers::Other => self.model.own_part(step, self.omega),
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
struct Room<'m, N: Number> {
    entries: &'m mut [N],
    variables: &'m mut [Variable<N::Word>],
    paths: &'m mut [Path<N>],
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

/// A run at one frequency, in memory for as many variables as the model has at once.
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
                0 => on_stack::<N, 8, 36, 8>(model, at),
                1 => on_stack::<N, 24, 300, 24>(model, at),
                2 => on_stack::<N, 64, 2080, 64>(model, at),
                class => return beyond_stack(class, model, at),
            };
            match outcome {
                Err(Failure::Full) => self.class += 1,
                outcome => return outcome,
            }
        }
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

impl<N: Level<Word = f64>> At<N> {
    /// At `sign ω²`, where ω is the sum of two words.
    pub(crate) fn new(omega: [f64; 2], sign: f64, side: Side) -> Self {
        let of_elements = if sign < 0.0 { [0.0; 2] } else { omega };
        At { square: signed_square(omega, sign), toward: side.toward(), omega: of_elements }
    }
}

/// ω², of the sign of ω, of a frequency that is the sum of two words.
fn signed_square<N: Level>(omega: [N::Word; 2], sign: f64) -> Ball<N> {
    let [hi, lo] = omega;
    let square = if lo.vanishes() {
        Ball::of_product(hi, hi)
    } else {
        let omega = Ball::exactly(N::of_word(hi).plus(N::of_word(lo)));
        omega * omega
    };
    square.scaled(sign)
}

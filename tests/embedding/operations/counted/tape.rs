//! The tape: a node for each operation, and which of them a result depends on.

use super::{ADD, COS, DIV, EXP, MUL, Operations, SIN, SQRT};
use std::cell::RefCell;

/// Where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Origin {
    /// A constant of the program.
    Constant(f64),
    /// A parameter, a frequency or what was made of them before.
    Given,
    /// The result of a node.
    Node(usize),
}

impl Origin {
    fn is_constant(self) -> bool {
        matches!(self, Origin::Constant(_))
    }
}

/// What a node does.
#[derive(Clone, Copy, Debug)]
pub(super) enum Operation {
    /// A subtraction as well.
    Add,
    Multiply,
    Divide,
    SquareRoot,
    /// Sine and cosine.
    Circle,
    Exponential,
    /// Counts nothing: the negative, the absolute value, the product with a power of two, one of the numbers that come
    /// with a circle or an exponential.
    Free,
}

impl Operation {
    /// What it counts.
    fn counts(self) -> Operations {
        match self {
            Operation::Add => ADD,
            Operation::Multiply => MUL,
            Operation::Divide => DIV,
            Operation::SquareRoot => SQRT,
            Operation::Circle => SIN + COS,
            Operation::Exponential => EXP,
            Operation::Free => Operations::default(),
        }
    }
}

/// All nodes of one evaluation.
#[derive(Default)]
pub(super) struct Tape {
    /// Whether operations are nodes: not while a model is built.
    recording: bool,
    nodes: Vec<(Operation, [Origin; 2])>,
    /// What branches have looked at.
    looked_at: Vec<Origin>,
}

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::default();
}

/// Starts a recording.
pub(super) fn start() {
    TAPE.set(Tape { recording: true, ..Tape::default() });
}

/// Ends it.
pub(super) fn stop() -> Tape {
    TAPE.take()
}

/// The origin of a number that stands in the program or is given to it.
pub(super) fn literal(value: f64) -> Origin {
    TAPE.with_borrow(|tape| if tape.recording { Origin::Constant(value) } else { Origin::Given })
}

/// The origin of the result `value` of an operation; one with a single operand has it twice.
pub(super) fn result(operation: Operation, operands: [Origin; 2], value: f64) -> Origin {
    TAPE.with_borrow_mut(|tape| {
        if !tape.recording {
            return Origin::Given;
        }
        if operands.iter().all(|operand| operand.is_constant()) {
            return Origin::Constant(value);
        }
        tape.nodes.push((operation, operands));
        Origin::Node(tape.nodes.len() - 1)
    })
}

/// A branch depends on a number.
pub(super) fn look_at(origin: Origin) {
    TAPE.with_borrow_mut(|tape| tape.looked_at.push(origin));
}

impl Tape {
    pub(super) fn executed(&self) -> Operations {
        self.nodes.iter().fold(Operations::default(), |sum, (operation, _)| sum + operation.counts())
    }

    /// Operations that certain results and the branches on the way to them depend on.
    pub(super) fn needed_for(&self, results: impl IntoIterator<Item = Origin>) -> Operations {
        let mut pending: Vec<Origin> = self.looked_at.iter().copied().chain(results).collect();
        let mut visited = vec![false; self.nodes.len()];
        let mut sum = Operations::default();
        while let Some(origin) = pending.pop() {
            if let Origin::Node(index) = origin
                && !core::mem::replace(&mut visited[index], true)
            {
                let (operation, operands) = self.nodes[index];
                sum = sum + operation.counts();
                pending.extend(operands);
            }
        }
        sum
    }
}

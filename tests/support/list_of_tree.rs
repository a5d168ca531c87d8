//! A tree as a list of steps of the library, with a plan and without.
#![expect(clippy::unwrap_used, reason = "random trees are valid lists")]

use super::tree::{Part, Tree};
use mstmm::elements::Mass;
use mstmm::list::{AnyElement, AnyUndamped, InList, ListElement, ListStep, PlannedList, Room, StepList};
use mstmm::motion::{Label, Point};
use mstmm::number::Real;

/// Most steps of a tree with a plan.
pub(crate) const MOST: usize = 40;

/// A tree that answers all that a model answers.
pub(crate) type Planned<E> = PlannedList<'static, E, MOST>;

/// The steps with every element built by `build`.
fn steps<E>(tree: &Tree, build: impl Fn(Part) -> E) -> Vec<ListStep<E>> {
    let step = |step: &ListStep<Part>| match *step {
        ListStep::Tip(support) => ListStep::Tip(support),
        ListStep::Element(part) => ListStep::Element(build(part)),
        ListStep::Connection(inputs) => ListStep::Connection(inputs),
        ListStep::Root(support) => ListStep::Root(support),
    };
    tree.iter().map(step).collect()
}

/// The steps of a tree without dashpots.
pub(crate) fn undamped_steps<T: Real>(tree: &Tree) -> Vec<ListStep<AnyUndamped<T>>> {
    steps(tree, Part::undamped)
}

/// The steps of any tree.
pub(crate) fn any_steps<T: Real>(tree: &Tree) -> Vec<ListStep<AnyElement<T>>> {
    steps(tree, Part::any)
}

/// A list of steps with its plan, in memory that is never given back.
fn planned<E: ListElement>(steps: Vec<ListStep<E>>) -> Planned<E> {
    let room = Box::leak(Box::new(Room::new()));
    StepList::new(steps.leak()).unwrap().planned(room).unwrap()
}

/// A tree without dashpots, with its plan.
pub(crate) fn undamped<T: Real>(tree: &Tree) -> Planned<AnyUndamped<T>> {
    planned(undamped_steps(tree))
}

/// Any tree with its plan.
pub(crate) fn any<T: Real>(tree: &Tree) -> Planned<AnyElement<T>> {
    planned(any_steps(tree))
}

/// The point behind a step, on its upstream side or `beyond` what acts there; tips have points, too.
pub(crate) fn point(step: usize, beyond: bool) -> Point<InList> {
    if beyond { Point::connection(step) } else { Label::<InList, Mass<f64>>::new(step, 0).output() }
}

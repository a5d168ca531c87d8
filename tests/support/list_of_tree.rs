//! A tree as a list of steps of the library.
#![expect(clippy::unwrap_used, clippy::panic, reason = "random trees have valid parameters")]

use super::tree::{Part, Tree};
use mstmm::list::{AnyElement, AnyUndamped, ListStep};

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
pub(crate) fn undamped_steps(tree: &Tree) -> Vec<ListStep<AnyUndamped<f64>>> {
    steps(tree, |part| {
        match part {
            Part::Beam(element) => element.try_into(),
            Part::Body(element) => element.try_into(),
            Part::ElasticHinge(element) => element.try_into(),
            Part::PointMass(element) => element.try_into(),
            Part::Spring(element) => element.try_into(),
            Part::TorsionSpring(element) => element.try_into(),
            Part::Mass(element) => element.try_into(),
            Part::Inertia(element) => element.try_into(),
            dashpot => panic!("{dashpot:?} in an undamped tree"),
        }
        .unwrap()
    })
}

/// The steps of any tree.
pub(crate) fn any_steps(tree: &Tree) -> Vec<ListStep<AnyElement<f64>>> {
    steps(tree, |part| {
        match part {
            Part::Beam(element) => element.try_into(),
            Part::Body(element) => element.try_into(),
            Part::ElasticHinge(element) => element.try_into(),
            Part::PointMass(element) => element.try_into(),
            Part::Spring(element) => element.try_into(),
            Part::TorsionSpring(element) => element.try_into(),
            Part::Mass(element) => element.try_into(),
            Part::Inertia(element) => element.try_into(),
            Part::Damper(element) => element.try_into(),
            Part::TorsionDamper(element) => element.try_into(),
            Part::SpringDamper(element) => element.try_into(),
            Part::TorsionSpringDamper(element) => element.try_into(),
        }
        .unwrap()
    })
}

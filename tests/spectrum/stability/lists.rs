//! Lists whose elements may have negative stiffness: only those in which one has are asked.

use crate::stability::link::Link;
use mstmm::__private::VisitStep;
use mstmm::element::{Element, FrequencyEstimates, Space, Support};
use mstmm::elements::{Mass, Spring};
use mstmm::list::{AnyUndamped, ListElement, ListStep, ListStepping, Room, StepList};
use mstmm::number::Frequency;
use mstmm::prelude::*;
use mstmm::search::{SearchError, System};

/// A built-in element, or a link.
#[derive(Clone, Copy, Debug)]
enum Piece {
    Stable(AnyUndamped<f64>),
    Link(Link<f64>),
}

impl ListElement for Piece {
    type Parameter = f64;
    const MAY_BUCKLE: bool = true;

    fn may_buckle(&self) -> bool {
        matches!(self, Piece::Link(_))
    }

    fn space(&self) -> Space {
        Space::Translation
    }

    fn parameters(&self) -> &'static [&'static str] {
        &[]
    }

    fn estimate(&self, estimates: &mut FrequencyEstimates) {
        match self {
            Piece::Stable(element) => element.estimate(estimates),
            Piece::Link(link) => Link::estimate(link, estimates),
        }
    }
}

impl<S: Frequency<f64>> ListStepping<S> for Piece {
    fn visit_step<V: VisitStep<S>>(&self, visitor: V) -> V::Output {
        match self {
            Piece::Stable(element) => element.visit_step(visitor),
            Piece::Link(link) => visitor.element::<Link<f64>>(link),
        }
    }
}

fn stable<E>(element: E) -> ListStep<Piece>
where
    AnyUndamped<f64>: TryFrom<E, Error: core::fmt::Debug>,
{
    ListStep::Element(Piece::Stable(element.try_into().unwrap()))
}

/// Two masses on two springs, the second of which is some piece.
fn steps(second: ListStep<Piece>) -> [ListStep<Piece>; 6] {
    [
        ListStep::Tip(Support::Fixed),
        stable(Spring { stiffness: 2.0 }),
        stable(Mass { mass: 1.0 }),
        second,
        stable(Mass { mass: 3.0 }),
        ListStep::Root(Support::Free),
    ]
}

fn link(stiffness: f64) -> ListStep<Piece> {
    ListStep::Element(Piece::Link(Link { stiffness }))
}

/// `det K = k₁ k₂`.
#[test]
fn a_link_in_a_list_decides() {
    for (stiffness, modes) in [(5.0, 0), (-5.0, 1), (-1e-5, 1)] {
        let steps = steps(link(stiffness));
        let mut room = Room::<6>::new();
        let list = StepList::new(&steps).unwrap();
        assert_eq!(list.unstable_modes(), Ok(modes));
        let planned = list.planned(&mut room).unwrap();
        assert_eq!(planned.unstable_modes(), Ok(modes));
        let expected = if modes > 0 { Err(SearchError::Unstable { modes }) } else { Ok(2) };
        assert_eq!(planned.count_below(1e3), expected);
    }
}

#[test]
fn a_list_without_a_link_is_not_evaluated() {
    let (with, without) = (steps(link(5.0)), steps(stable(Spring { stiffness: 5.0 })));
    let [with, without] = [&with, &without].map(|steps| StepList::new(steps).unwrap());
    assert!(with.may_buckle() && !without.may_buckle());
    assert_eq!(without.unstable_modes(), Ok(0));
    let [found, expected] = [&with, &without].map(|list| list.first_frequencies::<2>().unwrap());
    assert_eq!(found.evaluations(), expected.evaluations());
    for (found, expected) in found.iter().zip(&expected) {
        assert!(!found.is_proven);
        assert!(found.lower <= expected.omega && expected.omega <= found.upper, "{found:?} beside {expected:?}");
    }
}

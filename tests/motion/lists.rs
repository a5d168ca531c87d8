//! What a list says where it is asked amiss.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use mstmm::elements::{Mass, Spring};
use mstmm::list::{AnyUndamped, ListStep, Room, StepList, Support};
use mstmm::motion::MotionError;
use mstmm::prelude::*;

type Steps = Vec<ListStep<AnyUndamped<f64>>>;

/// So many masses in a row, each on a spring, as steps.
fn chain(cells: usize) -> Steps {
    let mut steps = vec![ListStep::Tip(Support::Fixed)];
    for _ in 0..cells {
        steps.push(ListStep::Element(Spring { stiffness: 4.0 }.try_into().unwrap()));
        steps.push(ListStep::Element(Mass { mass: 1.0 }.try_into().unwrap()));
    }
    steps.push(ListStep::Root(Support::Free));
    steps
}

/// A label of a longer list is no point of a shorter one, where its step is the root or beyond.
#[test]
fn a_label_of_a_longer_list_has_no_entry() {
    let (short, long) = (chain(1), chain(3));
    let (mut first, mut second) = (Room::<8>::new(), Room::<8>::new());
    let short = StepList::new(&short).unwrap().planned(&mut first).unwrap();
    let long = StepList::new(&long).unwrap().planned(&mut second).unwrap();
    let own = short.label(2).unwrap().output();
    for step in 3..=6 {
        let other = long.label(step).unwrap().output();
        for (load, entry) in [(other.force(), own.deflection()), (own.force(), other.deflection())] {
            let found = short.frequency_response(load, entry).map(|_| ());
            assert!(matches!(found, Err(MotionError::NoSuchEntry { .. })), "{step}: {found:?}");
        }
    }
}

/// Each mistake has its step and its words.
#[test]
fn a_list_names_what_is_wrong_and_where() {
    let spring = || ListStep::Element(AnyUndamped::try_from(Spring { stiffness: 4.0 }).unwrap());
    let (tip, root) = (|| ListStep::Tip(Support::Fixed), || ListStep::Root(Support::Free));
    let cases: [(Steps, usize, &str); 9] = [
        (vec![], 0, "the list is empty"),
        (vec![tip(), spring()], 2, "the list does not end in a root"),
        (vec![tip(), spring(), root(), spring()], 2, "steps follow the root"),
        (vec![root()], 0, "no path is open"),
        (vec![spring(), root()], 0, "no path is open"),
        (vec![tip(), spring(), tip(), spring(), root()], 4, "several paths are open"),
        (vec![tip(), root()], 1, "has no element"),
        (vec![tip(), spring(), ListStep::Connection(0), root()], 2, "one path or more"),
        (vec![tip(), spring(), ListStep::Connection(2), root()], 2, "fewer paths are open"),
    ];
    for (steps, step, words) in cases {
        let error = StepList::new(&steps).unwrap_err();
        assert!(error.step == step && error.problem.contains(words), "{error}");
    }
    let element = AnyUndamped::try_from(Spring { stiffness: 0.0 }).unwrap_err();
    assert!(element.to_string().starts_with("Spring: stiffness is 0, but must be"), "{element}");
}

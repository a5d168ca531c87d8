//! What a list says where it is asked amiss.

use crate::support::list_of_tree::undamped;
use crate::support::tree::chain;
use mstmm::elements::Spring;
use mstmm::list::{AnyUndamped, ListStep, StepList, Support};
use mstmm::motion::MotionError;
use mstmm::prelude::*;

type Steps = Vec<ListStep<AnyUndamped<f64>>>;

/// A label of a longer list is no point of a shorter one, where its step is the root or beyond.
#[test]
fn a_label_of_a_longer_list_has_no_entry() {
    let [short, long] = [1, 3].map(|masses| undamped::<f64>(&chain(masses, 4.0, 1.0)));
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
    let element = AnyUndamped::try_from(Spring { stiffness: -1.0 }).unwrap_err();
    assert!(element.to_string().starts_with("Spring: stiffness is -1, but must be"), "{element}");
}

//! Eigenvalues of undamped systems in strips along the imaginary axis: the two counts must agree.
#![expect(clippy::unwrap_used, reason = "all elements here are valid")]

use crate::support::list_of_tree::undamped_steps;
use crate::support::tree::chain;
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::prelude::*;

/// A chain of unit springs and masses: its frequencies are `2 sin((2k - 1)π/(4n + 2))`.
fn unit_chain(masses: usize) -> Vec<ListStep<AnyUndamped<f64>>> {
    undamped_steps(&chain(masses, 1.0, 1.0))
}

/// Oracle: Wittrick and Williams' count, from other arithmetic. The contour passes so close to many roots that between two
/// of them Δ looks flat: steps of whichever length must not lead from one such place to the next. Contours of all sizes, so
/// that their first steps end anywhere.
fn no_root_is_leapt_over_in_strips_that_grow_by(factor: f64) {
    for (masses, left, right) in [(11, 1e-5, 2e-6), (11, 1e-3, 1e-3), (24, 1e-3, 1e-5)] {
        let steps = unit_chain(masses);
        let list = StepList::new(&steps).unwrap();
        let mut top = 0.5;
        while top < 30.0 {
            let strip = |low| Region { re: -left * top..=right * top, im: low..=top };
            let below = list.count_below(top).unwrap();
            assert_eq!(list.count_in(strip(-top)), Ok(2 * below), "{masses} masses, up to {top}");
            for low in [0.02 * top, 0.1 * top, 0.3 * top] {
                let expected = below - list.count_below(low).unwrap();
                assert_eq!(list.count_in(strip(low)), Ok(expected), "{masses} masses, {low} to {top}");
            }
            top *= factor;
        }
    }
}

#[test]
fn no_root_of_some_narrow_strips_is_leapt_over() {
    no_root_is_leapt_over_in_strips_that_grow_by(1.4);
}

#[test]
#[ignore = "long: .ci/long"]
fn no_root_of_a_narrow_strip_is_leapt_over() {
    no_root_is_leapt_over_in_strips_that_grow_by(1.03);
}

/// Closed form: the chain's frequencies, each an eigenvalue on the imaginary axis; and what they cost.
#[test]
fn every_root_of_a_strip_is_found_in_few_evaluations() {
    let masses = 24;
    let steps = unit_chain(masses);
    let list = StepList::new(&steps).unwrap();
    let found = list.eigenvalues::<64>(Region { re: -1e-3..=1e-3, im: 0.0..=3.0 }).unwrap();
    assert_eq!(found.len(), masses);
    for (k, root) in found.iter().enumerate() {
        let exact = 2.0 * ((2 * k + 1) as f64 * core::f64::consts::PI / (4 * masses + 2) as f64).sin();
        let distance = (root.lambda - Complex::new(0.0, exact)).norm();
        assert!(root.multiplicity == 1 && distance <= root.error + 4.0 * f64::EPSILON, "{root:?}: {exact}");
    }
    assert!(found.evaluations() <= 30 * masses, "{}", found.evaluations());
}

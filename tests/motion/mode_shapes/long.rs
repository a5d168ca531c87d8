//! Many modes of one system.

use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality, first};
use crate::mode_shapes::models::Spans;

/// Two spans with irrational ratio, so that no mode has its node at the pin by accident.
fn spans() -> Spans {
    Spans { l1: 1.0, l2: 2f64.sqrt(), ei: 63_476.125, m: 15.3875 }
}

#[test]
#[ignore = "long: .ci/long"]
fn thousand_modes_of_two_spans_keep_all_laws() {
    let (model, system) = (spans(), spans().build().unwrap());
    let roots = first::<1000>(&system);
    assert_eq!(roots.len(), 1000);
    println!("residual {:?}", check_laws(&model, &system, &roots));
}

#[test]
#[ignore = "long: .ci/long"]
fn modes_of_two_spans_are_orthogonal_and_give_their_frequencies() {
    let (model, system) = (spans(), spans().build().unwrap());
    let roots = first::<1000>(&system);
    println!("products of low modes {:e}", check_orthogonality(&system, &roots[..20]));
    println!("products of high modes {:e}", check_orthogonality(&system, &roots[980..]));
    let few: Vec<_> = roots.iter().copied().step_by(37).chain([roots[998], roots[999]]).collect();
    println!("energies {:e}", check_energies(&model, &system, &few));
}

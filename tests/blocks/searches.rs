//! Counts, Δ and certified roots of models on every instruction set.

use crate::support::roots::assert_same_intervals;
use crate::undamped_models::for_each_undamped;
use crate::values::{assert_counts, assert_values, frequencies};
use mstmm::element::ParameterError;
use mstmm::prelude::*;
use mstmm::search::{InBlocks, System};
use mstmm_lanes::InstructionSet;
use paper::models;

/// Oracle: the same question to one number at a time; roots may differ within their certified intervals alone.
fn check<Y: Undamped + InBlocks<f64> + System<Parameter = f64>>(system: Y) {
    let omegas = frequencies(3, 60);
    assert_values(&system, &omegas);
    assert_counts(&system, &omegas);
    InstructionSet::Target.limit();
    let alone = system.first_frequencies::<2>();
    for set in InstructionSet::ALL {
        let set = set.limit();
        let found = system.first_frequencies::<2>();
        // a tree without beams may have too few
        let (Ok(found), Ok(alone)) = (&found, &alone) else {
            assert_eq!(found.is_err(), alone.is_err(), "{set:?}: {found:?} and {alone:?}");
            continue;
        };
        assert_same_intervals(found, alone, &set);
    }
}

#[test]
fn examples_of_the_paper() {
    check(models::light_tip_body().build().unwrap());
    check(models::restrained_beam().build().unwrap());
    check(models::spring_and_mass().build().unwrap());
    check(models::two_spans().build().unwrap());
}

system! {
    /// Hinges of one freedom, with stiffness and without, and levers that lead away and back.
    struct Jointed { crack: f64, slide: f64, arm: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 1.0 } -> hinge 2 { stiffness_rz: crack }
          -> rigid_link 3 { output_x: arm } -> beam 4 { length: 0.5, bending_stiffness: 1.0, mass_per_length: 1.5 } -> conn 5
          -> hinge 6 { stiffness_y: slide } -> rigid_link 7 { output_x: -arm } -> rigid_link 8 { output_x: arm }
          -> beam 9 { length: 0.75, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
    conn 5 <- rigid_link 10 { output_x: arm } <- point_mass 11 { mass: 0.5, inertia: 0.1 } <- free;
}

#[test]
fn joints() {
    for (crack, slide, arm) in [(0.0, 3.0, 0.25), (2.0, 0.0, -0.5), (1e9, 1e-6, 30.0), (0.0, 0.0, 0.0)] {
        check(Jointed { crack, slide, arm }.build().unwrap());
    }
}

#[test]
fn random_trees_as_models() {
    fn check_built<Y: Undamped + InBlocks<f64> + System<Parameter = f64>>(_: u64, system: Result<Y, ParameterError>) {
        check(system.unwrap());
    }
    for_each_undamped!(check_built);
}

/// A function that is called and not in line is compiled for the least machine, and its vector operations become calls: thirty times as
/// slow, and right.
#[test]
#[cfg_attr(debug_assertions, ignore = "debug builds have no lanes: .ci/long")]
fn no_operation_on_a_vector_is_a_call() {
    use object::{Object, ObjectSymbol};
    let bytes = std::fs::read(std::env::current_exe().unwrap()).unwrap();
    let file = object::File::parse(bytes.as_slice()).unwrap();
    let names: Vec<_> = file.symbols().filter_map(|symbol| symbol.name().ok()).collect();
    assert!(names.iter().any(|name| name.contains("on_avx512")), "without symbols nothing can be seen");
    let calls: Vec<_> = names.iter().filter(|name| name.contains("_mm512_") || name.contains("_mm256_")).collect();
    assert!(calls.is_empty(), "{calls:?}");
}

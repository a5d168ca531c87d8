//! Structures whose members hang together at clamps alone: each is by itself, all are one network.

use crate::structure::{Node, Section, Structure};
use crate::through_library::{first, width};

const SECTION: Section = Section { axial_stiffness: 1e6, bending_stiffness: 1.0, mass_per_length: 1.0 };

/// Asserts that the first frequencies are these for each member.
#[track_caller]
fn assert_each(structure: &Structure, members: usize, expected: f64) {
    let found = first(structure).unwrap_or_else(|error| unreachable!("{error}"));
    assert_eq!(found[0].multiplicity, members as u64, "{found:?}");
    assert!((found[0].omega / expected - 1.0).abs() < 1e-14, "{found:?}");
}

#[test]
fn many_cantilevers_on_one_clamp() {
    let mut structure = Structure::default();
    let clamp = structure.clamp([0.0, 0.0]);
    for k in 0..60 {
        let (sin, cos) = (k as f64).sin_cos();
        let tip = structure.node(Node::at([cos, sin]));
        structure.beam(clamp, tip, SECTION);
    }
    // cos z cosh z = -1
    assert_each(&structure, 60, 1.875_104_068_711_961_2_f64.powi(2));
    assert_eq!(width(&structure), 6);
}

#[test]
fn many_beams_between_two_clamps() {
    let mut structure = Structure::default();
    let clamps = [[0.0, 0.0], [0.6, 0.8]].map(|place| structure.clamp(place));
    for _ in 0..5 {
        structure.beam(clamps[0], clamps[1], SECTION);
    }
    // cos z cosh z = 1
    assert_each(&structure, 5, 4.730_040_744_862_704_f64.powi(2));
}

//! Structures in which a point without mass is held by nothing, or a body twice: Δ vanishes at every frequency.

use crate::structure::{End, Freedoms, Node, Section, Structure};
use crate::through_library::asked;
use mstmm::prelude::*;
use mstmm::search::{SearchError, Spot};

const SECTION: Section = Section { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 };

/// A cantilever whose free end holds what nothing else does.
fn beside_a_beam(add: impl FnOnce(&mut Structure, usize)) -> Structure {
    let mut structure = Structure::default();
    let root = structure.clamp([0.0, 0.0]);
    let tip = structure.node(Node::at([1.0, 0.0]));
    structure.beam(root, tip, SECTION);
    add(&mut structure, tip);
    structure
}

/// The point at which a search says that Δ vanishes.
#[track_caller]
fn refused_at(structure: &Structure) -> usize {
    let found = asked(structure, |network| Ok(network.first_frequencies::<3>()));
    match found {
        Ok(Err(SearchError::Zero { at: Some(Spot::Node(node)), .. })) => node,
        other => unreachable!("{other:?}\n{structure:?}"),
    }
}

#[test]
fn a_point_on_collinear_springs_is_named_whatever_their_stiffness() {
    for decade in -12..=12 {
        for direction in [[1.0, 0.3], [0.0, 1.0], [-3.0, 1e-3]] {
            let mut loose = 0;
            let structure = beside_a_beam(|structure, tip| {
                let at = |part: f64| [1.0 + part * direction[0], part * direction[1]];
                let between = structure.node(Node::at(at(0.7)).held(Freedoms::RZ));
                let end = structure.clamp(at(1.7));
                structure.spring_along(tip, between, direction, 3.0 * 10.0_f64.powi(decade));
                structure.spring_along(between, end, direction, 5.0);
                loose = between;
            });
            assert_eq!(refused_at(&structure), loose, "1e{decade} along {direction:?}");
        }
    }
}

#[test]
fn a_point_on_one_spring_is_named() {
    let mut loose = 0;
    let structure = beside_a_beam(|structure, tip| {
        loose = structure.node(Node::at([2.0, 1.0]));
        structure.spring_along(tip, loose, [1.0, 1.0], 3.0);
    });
    assert_eq!(refused_at(&structure), loose);
}

/// Two bodies on one axle, welded to each other at another point: both hold it there, on the one hand through the lever of the one, on the
/// other hand through that of the other. A beam leads from the weld to a clamp.
fn on_one_axle(lever: [f64; 2], mass: f64) -> Structure {
    let mut structure = Structure::default();
    let axle = structure.node(Node::at([0.0, 0.0]).held(Freedoms::PIN));
    let bodies = [mass, 2.0].map(|mass| structure.node(Node::at(lever).body(mass, 0.1 * mass, lever)));
    for body in bodies {
        structure.weld(axle, End::from(body).at([0.0, 0.0]), Freedoms::PIN);
    }
    structure.weld(bodies[0], bodies[1], Freedoms::ALL);
    let root = structure.clamp([lever[0] + 1.0, lever[1] - 0.5]);
    structure.beam(bodies[1], root, SECTION);
    structure
}

#[test]
fn two_levers_on_one_axle_are_refused_whatever_their_length() {
    for decade in -6..=6 {
        let length = 10.0_f64.powi(decade);
        for direction in [[1.0, 0.0], [0.3, -1.7], [1e-3, 1.0]] {
            for mass in [1e-6, 1.0, 1e6] {
                refused_at(&on_one_axle(direction.map(|part| part * length), mass));
            }
        }
    }
}

/// A ring of bodies, welded to each other but for two pins, on a beam: so it is held twice along the line through the pins. Returns the
/// bodies, too.
fn ring_with_two_pins(size: f64, turn: f64) -> (Structure, Vec<usize>) {
    let mut bodies = Vec::new();
    let structure = beside_a_beam(|structure, tip| {
        let place = |part: f64| {
            let (sin, cos) = (turn + core::f64::consts::TAU * part / 7.0).sin_cos();
            [2.0 + size * cos, 0.5 + size * sin]
        };
        let body = |part: u8| Node::at(place(part.into())).body(1.0, 0.1 * size * size, place(part.into()));
        bodies.extend((0..7).map(|part| structure.node(body(part))));
        for part in 0..7 {
            let joint = place(part as f64 + 0.5);
            let shared = if part == 1 || part == 6 { Freedoms::PIN } else { Freedoms::ALL };
            let ends = [bodies[part], bodies[(part + 1) % 7]].map(|body| End::from(body).at(joint));
            structure.weld(ends[0], ends[1], shared);
        }
        structure.beam(tip, bodies[0], SECTION);
    });
    (structure, bodies)
}

/// Roundings add up around a ring: no row is small enough to be nothing by itself, and only another choice of pivots, which leaves Δ without
/// a digit in common, tells that it is zero.
#[test]
fn a_ring_that_is_held_twice_is_refused_at_one_of_its_bodies() {
    for decade in -1..=1 {
        for turn in [1.1, 1.3] {
            let (structure, bodies) = ring_with_two_pins(10.0_f64.powi(decade), turn);
            let node = refused_at(&structure);
            assert!(bodies.contains(&node), "{node} of {bodies:?}, size 1e{decade} turned by {turn}");
        }
    }
}

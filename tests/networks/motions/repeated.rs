//! Shapes of multiple roots, beside others and alone, and forces of motions that are nearly rigid.
#![expect(clippy::unwrap_used, reason = "the structures are right")]

use crate::structure::{Freedoms, Node, Section, Structure};
use crate::through_library::{Undamped, asked};
use mstmm::motion::{MemberLabel, MotionError, PlanePoint};
use mstmm::network::InNetwork;
use mstmm::prelude::*;

const SECTION: Section = Section { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 };

/// The roots of a structure of a multiplicity, with a question about them.
fn ask<R: Send>(
    structure: &Structure,
    multiplicity: u64,
    question: impl Fn(&Undamped, &NaturalFrequency<f64>) -> R + Send + Sync,
) -> Vec<R> {
    let told = asked(structure, |network| {
        let roots = network.natural_frequencies::<12>(0.0..=100.0).map_err(|error| error.to_string())?;
        Ok(roots.iter().filter(|root| root.multiplicity == multiplicity).map(|root| question(network, root)).collect())
    });
    told.unwrap()
}

/// Beams of the same length between clamps share all roots; nothing else moves.
#[test]
fn equal_beams_between_clamps_move_each_alone() {
    for count in 2..=6_u32 {
        let mut structure = Structure::default();
        let clamps: Vec<usize> = (0..=count).map(|k| structure.clamp([f64::from(k), 0.0])).collect();
        clamps.windows(2).for_each(|pair| structure.beam(pair[0], pair[1], SECTION));
        let seen = ask(&structure, u64::from(count), |network, root| {
            let shapes = network.mode_shapes::<6, _>(root).unwrap();
            let of_shape = |shape: &mstmm::motion::PlaneShape<'_, Undamped, f64>| {
                let members = 0..count as usize;
                let ends = members.flat_map(|member| shape.member(member).unwrap()).copied();
                let moved = ends.flat_map(|end| end.displacements).map(f64::abs).fold(0.0, f64::max);
                (moved, (shape.modal_stiffness() / root.omega.powi(2) - 1.0).abs())
            };
            shapes.iter().map(of_shape).collect::<Vec<_>>()
        });
        assert!(!seen.is_empty());
        for (moved, stiffness) in seen.into_iter().flatten() {
            assert!(moved < 1e-12 && stiffness < 1e-11, "{count} beams: {moved:e} {stiffness:e}");
        }
    }
}

/// Masses on springs of their own, the first of another stiffness.
fn oscillators(stiffnesses: &[f64]) -> Structure {
    let mut structure = Structure::default();
    let ground = structure.clamp([0.0, 0.0]);
    for (k, stiffness) in stiffnesses.iter().enumerate() {
        let held = Freedoms::Y.union(Freedoms::RZ);
        let place = [1.0 + k as f64, 0.0];
        let mass = structure.node(Node::at(place).held(held).body(1.0, 0.0, place));
        structure.spring(ground, mass, *stiffness);
    }
    structure
}

#[test]
fn equal_oscillators_follow_the_ground_alike() {
    let structure = oscillators(&[100.0, 1.0, 1.0, 1.0]);
    let told = asked(&structure, |network| {
        let roots = network.first_frequencies::<4>().map_err(|error| error.to_string())?;
        let moved = (1..=4).map(|node| {
            let entry = PlanePoint::node(node).displacement_x();
            let response = network.modal_response::<4, _>(&roots, PlanePoint::node(0).motion_x(), entry).unwrap();
            [response.to_step(1.0), response.to_impulse(1.0)]
        });
        Ok(moved.collect::<Vec<_>>())
    });
    for (node, moved) in told.unwrap().into_iter().enumerate() {
        let omega = if node == 0 { 10.0_f64 } else { 1.0 };
        let expected = [1.0 - omega.cos(), omega * omega.sin()];
        for (found, expected) in moved.into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11, "{node}: {found} {expected}");
        }
    }
}

/// Two bodies that nothing holds and a spring between them move by themselves, five ways.
#[test]
fn free_bodies_have_all_their_motions() {
    let mut structure = Structure::default();
    let bodies = [[0.0, 0.0], [2.0, 0.0]].map(|place| structure.node(Node::at(place).body(1.0, 1.0, place)));
    structure.spring(bodies[0], bodies[1], 1.0);
    let forces = ask(&structure, 5, |network, root| {
        let shapes = network.mode_shapes::<5, _>(root).unwrap();
        let spring = MemberLabel::<InNetwork, ()>::member(0).input();
        shapes.iter().map(|shape| shape.value(spring.axial_force()).unwrap().abs()).fold(0.0, f64::max)
    });
    assert!(forces.len() == 1 && forces[0] < 1e-9, "{forces:?}");
}

/// A root twice, and a third one so far away: from some distance on it is at rest, from another on nobody can tell.
#[test]
fn roots_beside_a_multiple_one_are_told_apart_or_refused() {
    for (distance, is_told) in [(1e-3, true), (1e-6, true), (1e-9, true), (1e-12, false)] {
        let structure = oscillators(&[1.0, 1.0, 1.0 + distance]);
        let told = ask(&structure, 2, |network, root| {
            let shapes = network.mode_shapes::<2, _>(root)?;
            let third = shapes.iter().map(|shape| shape.node(3).unwrap()[0].abs()).fold(0.0, f64::max);
            Ok(third)
        });
        for third in told {
            match third {
                Ok(third) => assert!(is_told && third < 1e-9, "{distance:e}: {third:e}"),
                Err(error) => {
                    assert!(!is_told && matches!(error, MotionError::Unresolved { .. }), "{distance:e}: {error}")
                }
            }
        }
    }
}

/// A free square with a body under a force: axial forces hardly change while it moves slower and slower.
#[test]
fn forces_of_slow_motions_are_those_of_slower_ones() {
    let mut structure = Structure::default();
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]].map(|place| structure.node(Node::at(place)));
    let last = structure.node(Node::at([0.0, 1.0]).body(3.0, 0.2, [0.1, 1.2]));
    let nodes = [corners[0], corners[1], corners[2], last];
    (0..4).for_each(|k| structure.beam(nodes[k], nodes[(k + 1) % 4], SECTION));
    for member in 0..4 {
        let told = asked(&structure, |network| {
            let entry = MemberLabel::<InNetwork, ()>::member(member).input().axial_force();
            let response = network.frequency_response(PlanePoint::node(0).force_x(), entry).unwrap();
            Ok([1e-3, 3e-4, 1e-4, 5e-5, 1e-5, 0.0].map(|omega| response.at(omega).unwrap()))
        });
        let [first, rest @ ..] = told.unwrap();
        for found in rest {
            assert!((found - first).abs() < 1e-6 * 0.1, "{member}: {found} {first}");
            assert!((found - rest[3]).abs() < 2e-9, "{member}: {found} {}", rest[3]);
        }
    }
}

//! Motions inside of members: those of structures in which a node stands there, integrals, closed forms.
#![expect(clippy::unwrap_used, reason = "the structure has the nodes and members that are asked for")]

use crate::families::damped::damped_structure;
use crate::families::random::Spread;
use crate::families::{Named, named_structures, random_structures};
use crate::structure::{Element, Freedoms, Node, Structure};
use crate::through_library::{Undamped, asked, asked_to_decay};
use mstmm::Complex;
use mstmm::motion::{MemberLabel, MemberState, MotionError, PlanePoint};
use mstmm::network::InNetwork;
use mstmm::prelude::*;

fn label(member: usize) -> MemberLabel<InNetwork, ()> {
    MemberLabel::member(member)
}

/// The structure with a node inside of a beam, at a part of its length. The beam is then the part before the node.
fn split(structure: &Structure, member: usize, part: f64) -> (Structure, usize, f64) {
    let mut split = structure.clone();
    let old = split.members[member];
    let Element::Beam(section) = old.element else { unreachable!("a beam is split") };
    let [[x, y], [to_x, to_y]] = old.ends.map(|end| structure.position(&end));
    let node = split.node(Node::at([x + part * (to_x - x), y + part * (to_y - y)]));
    split.members[member].ends[1] = node.into();
    split.beam(node, old.ends[1], section);
    (split, node, part * (to_x - x).hypot(to_y - y))
}

fn numbers<S: Copy>(state: &MemberState<S>) -> [S; 6] {
    [state.displacement_x, state.displacement_y, state.rotation_z, state.axial_force, state.shear, state.moment]
}

/// A beam of a structure that is not too stiff beside the others.
fn some_beam(structure: &Structure, seed: usize) -> Option<usize> {
    let is_beam = |member: &usize| matches!(structure.members[*member].element, Element::Beam(_));
    let beams: Vec<usize> = (0..structure.members.len()).filter(is_beam).collect();
    beams.get(seed % beams.len().max(1)).copied()
}

/// Displacements and forces at a place inside of a beam, and where a node stands there; the largest of each in the structure.
fn compare_undamped((name, structure): &Named, seed: usize, omega: f64, worst: &mut [f64; 2]) -> Option<()> {
    let member = some_beam(structure, seed)?;
    let part = [0.13, 0.5, 0.77][seed % 3];
    let (with_node, node, distance) = split(structure, member, part);
    let free = structure.nodes.iter().position(|node| node.held == Freedoms::NONE)?;
    let ask = |structure: &Structure, inside: bool| {
        asked(structure, |network: &Undamped| {
            let point = PlanePoint::node(free);
            let response = network.frequency_response(point.force_y(), point.displacement_x()).unwrap();
            let states = response.states(omega).map_err(|error| error.to_string())?;
            let mut largest = [0.0_f64; 2];
            for member in 0..structure.members.len() {
                for end in states.member(member).unwrap() {
                    largest[0] = end.displacements.iter().fold(largest[0], |sum, value| sum.max(value.abs()));
                    largest[1] = end.forces.iter().fold(largest[1], |sum, value| sum.max(value.abs()));
                }
            }
            if inside {
                return Ok((numbers(&states.along(label(member), distance).unwrap()), largest));
            }
            let ([x, y, rz], end) = (states.node(node).unwrap(), label(member).output());
            let [axial, shear, moment] =
                [end.axial_force(), end.shear(), end.moment()].map(|entry| states.value(entry).unwrap());
            Ok(([x, y, rz, axial, shear, moment], largest))
        })
    };
    let (Ok((found, _)), Ok((expected, largest))) = (ask(structure, true), ask(&with_node, false)) else {
        return None;
    };
    for k in (0..6).filter(|k| largest[k / 3] > 0.0) {
        let error = (found[k] - expected[k]).abs() / largest[k / 3];
        assert!(error < 1e-9, "{name}, beam {member} at {omega}: {found:?} {expected:?} of {largest:?}");
        worst[k / 3] = worst[k / 3].max(error);
    }
    Some(())
}

fn judge(structures: impl Iterator<Item = Named>) {
    let (mut compared, mut worst) = (0, [0.0; 2]);
    for (seed, structure) in structures.enumerate().filter(|(_, (_, structure))| structure.nodes.len() < 60) {
        for omega in [0.31, 17.0, 240.0, 5300.0] {
            compared += usize::from(compare_undamped(&structure, seed, omega, &mut worst).is_some());
        }
    }
    println!(
        "{compared} states inside of members, displacements {:.1e}, forces {:.1e} of the largest",
        worst[0], worst[1]
    );
    assert!(compared > 40);
}

#[test]
fn states_inside_of_members_are_those_at_a_node_there() {
    judge(named_structures().into_iter().chain(random_structures(0..20, Spread::Moderate)));
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn states_inside_of_members_of_hundreds_of_structures_are_those_at_a_node_there() {
    judge(random_structures(0..300, Spread::Moderate));
}

#[test]
fn damped_states_inside_of_members_are_those_at_a_node_there() {
    let (mut compared, mut worst) = (0, 0.0_f64);
    for seed in 0..20 {
        let structure = damped_structure(seed);
        let Some(member) = some_beam(&structure, seed as usize) else { continue };
        let (with_node, node, distance) = split(&structure, member, 0.4);
        let Some(free) = structure.nodes.iter().position(|node| node.held == Freedoms::NONE) else { continue };
        for lambda in [Complex::new(-0.2, 3.1), Complex::new(-31.0, 220.0), Complex::new(-400.0, 0.3)] {
            let ask = |structure: &Structure, inside: bool| {
                asked_to_decay(structure, |network| {
                    let point = PlanePoint::node(free);
                    let response = network.frequency_response(point.force_y(), point.displacement_x()).unwrap();
                    let states = response.states(lambda).map_err(|error| error.to_string())?;
                    let size = (0..structure.nodes.len()).flat_map(|node| states.node(node).unwrap());
                    let size = size.map(|value| value.norm()).fold(0.0, f64::max);
                    let found = if inside {
                        let state = states.along(label(member), distance).unwrap();
                        [state.displacement_x, state.displacement_y, state.rotation_z]
                    } else {
                        states.node(node).unwrap()
                    };
                    Ok((found, size))
                })
            };
            let (Ok((found, size)), Ok((expected, _))) = (ask(&structure, true), ask(&with_node, false)) else {
                continue;
            };
            for k in 0..3 {
                let error = (found[k] - expected[k]).norm() / size;
                assert!(error < 1e-9, "{seed} at {lambda}: {found:?} {expected:?}");
                worst = worst.max(error);
            }
            compared += 1;
        }
    }
    println!("{compared} damped states inside of members, {worst:.1e} of the largest");
    assert!(compared > 20);
}

/// The mass form by Simpson's rule along the members, and by what shares of energies say.
#[test]
fn shares_of_energies_are_integrals_along_members() {
    let (mut shares, mut worst) = (0, 0.0_f64);
    for (name, structure) in named_structures().into_iter().chain(random_structures(0..20, Spread::Moderate)) {
        if structure.nodes.len() > 40 {
            continue;
        }
        let told = asked(&structure, |network| {
            let roots = network.first_frequencies::<6>().map_err(|error| error.to_string())?;
            let mut off = Vec::new();
            for root in roots.iter().filter(|root| root.multiplicity == 1 && root.omega > 0.0) {
                let Ok(shape) = network.mode_shape(root) else { continue };
                let stiffness = shape.modal_stiffness() / (root.omega * root.omega);
                off.push((stiffness - 1.0).abs());
                let mut sums = [0.0; 2];
                for (index, member) in structure.members.iter().enumerate() {
                    let share = shape.energy_shares(label(index)).unwrap();
                    sums = [sums[0] + share.kinetic, sums[1] + share.strain];
                    let Element::Beam(section) = member.element else { continue };
                    let [[x, y], [to_x, to_y]] = member.ends.map(|end| structure.position(&end));
                    let (length, pieces) = ((to_x - x).hypot(to_y - y), 2000);
                    let at = |k: u32| {
                        // the end itself may be beyond the length by rounding
                        let distance = (length * f64::from(k) / f64::from(pieces)).min(length * (1.0 - 1e-15));
                        let state = shape.along(label(index), distance).unwrap();
                        state.displacement_x.powi(2) + state.displacement_y.powi(2)
                    };
                    let simpson = (0..=pieces).map(|k| {
                        let weight = if k == 0 || k == pieces { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
                        weight * at(k)
                    });
                    let integral = simpson.sum::<f64>() * length / f64::from(pieces) / 3.0;
                    off.push((share.kinetic - integral * section.mass_per_length).abs());
                }
                for node in 0..structure.nodes.len() {
                    sums[0] += shape.body_shares(PlanePoint::node(node)).unwrap().kinetic;
                }
                off.extend(sums.map(|sum| (sum - 1.0).abs()));
            }
            Ok(off)
        });
        let Ok(off) = told else { continue };
        shares += off.len();
        worst = off.iter().copied().fold(worst, f64::max);
        assert!(off.iter().all(|off| *off < 1e-8), "{name}: {off:?}");
    }
    println!("{shares} shares of energies, worst {worst:.1e}");
    assert!(shares > 500);
}

#[test]
fn a_beam_has_the_nodes_of_its_modes_and_unit_deflection() {
    let mut structure = Structure::default();
    let (foot, tip) = (structure.clamp([0.0, 0.0]), structure.node(Node::at([3.0, 4.0])));
    let section = crate::structure::Section { axial_stiffness: 1e9, bending_stiffness: 1.0, mass_per_length: 1.0 };
    structure.beam(foot, tip, section);
    structure.spring(foot, tip, 1e-3);
    let told = asked(&structure, |network| {
        let roots = network.first_frequencies::<6>().unwrap();
        for (mode, root) in roots.iter().enumerate() {
            let shape = network.mode_shape(root).unwrap();
            assert_eq!(shape.nodes(label(0)), Ok(mode));
            assert_eq!(shape.nodes(label(1)), Err(MotionError::NoInside));
            let unit = shape.with_unit_deflection().unwrap();
            // a cantilever deflects most at its tip
            let [x, y, _] = unit.node(tip).unwrap();
            assert!((x.hypot(y) - 1.0).abs() < 1e-12, "{mode}");
            let outside = unit.along(label(0), 5.1);
            assert_eq!(outside, Err(MotionError::Outside { distance: 5.1, length: 5.0 }));
        }
        Ok(())
    });
    told.unwrap();
}

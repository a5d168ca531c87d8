//! Motions of supports beside an oracle that frees what moves: a force there, divided by the displacement that it causes.
#![expect(clippy::unwrap_used, reason = "the structure has the nodes that are asked for")]

use crate::families::damped::damped_structure;
use crate::families::random::Spread;
use crate::families::{Named, named_structures, random_structures};
use crate::oracle::Oracle;
use crate::stiffness_matrix::discs::C;
use crate::structure::{Freedoms, Node, Structure};
use crate::through_library::{asked, asked_to_decay};
use mstmm::Complex;
use mstmm::motion::{MotionError, PlaneLoad, PlanePoint};
use mstmm::network::InNetwork;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

const OMEGAS: [f64; 4] = [0.0137, 0.41, 3.7, 29.3];

/// The displacements of all nodes, and the force of the support along its motion.
type Moved = (Vec<[Complex<f64>; 3]>, Complex<f64>);

fn load(node: usize, axis: usize) -> PlaneLoad<InNetwork> {
    let point = PlanePoint::node(node);
    [point.motion_x(), point.motion_y(), point.motion_z()][axis]
}

/// The structure with what moves freed, the direction of the motion, and how far it goes that way.
fn freed(structure: &Structure, node: usize, axis: usize) -> Option<(Structure, [f64; 3], f64)> {
    let mut freed = structure.clone();
    let mut direction = [0.0; 3];
    direction[axis] = 1.0;
    let own: &mut Node = &mut freed.nodes[node];
    if let Some([x, y]) = own.along.filter(|_| axis < 2) {
        let size = x.hypot(y);
        let across = [-y / size, x / size, 0.0];
        own.along = None;
        return (across[axis] != 0.0).then_some((freed, across, across[axis]));
    }
    let held = match axis {
        0 => &mut own.held.x,
        1 => &mut own.held.y,
        _ => &mut own.held.rz,
    };
    std::mem::take(held).then_some((freed, direction, 1.0))
}

/// The motion by the oracle.
fn exact(structure: &Structure, lambda: C, node: usize, axis: usize, damped: bool) -> Option<Moved> {
    let (freed, direction, far) = freed(structure, node, axis)?;
    let oracle = if damped { Oracle::damped(&freed) } else { Oracle::of(&freed) };
    let zero = C::new(DoubleDouble::from(0.0), DoubleDouble::from(0.0));
    let mut all = vec![[zero; 3]; structure.nodes.len()];
    for (axis, part) in direction.into_iter().enumerate().filter(|(_, part)| *part != 0.0) {
        for (sum, term) in all.iter_mut().zip(oracle.response(lambda, node, axis)?) {
            for k in 0..3 {
                sum[k] += term[k] * C::new(DoubleDouble::from(part), DoubleDouble::from(0.0));
            }
        }
    }
    let own = (0..3).fold(zero, |sum, k| sum + all[node][k] * C::new(DoubleDouble::from(direction[k]), zero.re));
    let factor = C::new(DoubleDouble::from(far), zero.re) / own;
    let plain = |value: C| Complex::new((value * factor).re.to_f64(), (value * factor).im.to_f64());
    let moved = all.iter().map(|node| node.map(plain)).collect();
    Some((moved, plain(C::new(DoubleDouble::from(1.0), zero.re))))
}

fn along(structure: &Structure, node: usize, axis: usize, force: [Complex<f64>; 3]) -> Complex<f64> {
    let (_, direction, _) = freed(structure, node, axis).unwrap();
    (0..3).fold(Complex::new(0.0, 0.0), |sum, k| sum + force[k] * direction[k])
}

fn undamped(structure: &Structure, omega: f64, node: usize, axis: usize) -> Result<Moved, String> {
    asked(structure, |network| {
        let entry = PlanePoint::node(0).displacement_x();
        let response = network.frequency_response(load(node, axis), entry).map_err(|error| error.to_string())?;
        let states = response.states(omega).map_err(|error| error.to_string())?;
        let complex = |node: [f64; 3]| node.map(|value| Complex::new(value, 0.0));
        let all = (0..structure.nodes.len()).map(|node| complex(states.node(node).unwrap())).collect();
        Ok((all, along(structure, node, axis, complex(states.reaction(node).unwrap()))))
    })
}

fn damped(structure: &Structure, lambda: Complex<f64>, node: usize, axis: usize) -> Result<Moved, String> {
    asked_to_decay(structure, |network| {
        let entry = PlanePoint::node(0).displacement_x();
        let response = network.frequency_response(load(node, axis), entry).map_err(|error| error.to_string())?;
        let states = response.states(lambda).map_err(|error| error.to_string())?;
        let all = (0..structure.nodes.len()).map(|node| states.node(node).unwrap()).collect();
        Ok((all, along(structure, node, axis, states.reaction(node).unwrap())))
    })
}

/// What differs, of the largest displacement, and of the reaction.
fn difference(one: &Moved, other: &Moved) -> [f64; 2] {
    let largest = other.0.iter().flatten().map(|value| value.norm()).fold(0.0, f64::max);
    let pairs = one.0.iter().flatten().zip(other.0.iter().flatten());
    let worst = pairs.map(|(one, other)| (one - other).norm()).fold(0.0, f64::max);
    [worst / largest, (one.1 - other.1).norm() / other.1.norm()]
}

fn supports(structure: &Structure) -> Vec<(usize, usize)> {
    let all = (0..structure.nodes.len()).flat_map(|node| (0..3).map(move |axis| (node, axis)));
    all.filter(|&(node, axis)| freed(structure, node, axis).is_some()).collect()
}

fn judge(structures: impl Iterator<Item = Named>, decays: bool) {
    let (mut compared, mut unsure, mut worst, mut wrong) = (0, 0, [0.0_f64; 2], Vec::new());
    for (name, structure) in structures {
        if structure.nodes.len() > 40 {
            continue;
        }
        let supports = supports(&structure);
        for (k, omega) in OMEGAS.into_iter().enumerate() {
            let Some(&(node, axis)) = supports.get(k * 5 % supports.len().max(1)) else { continue };
            let lambda = Complex::new(if decays { -0.1 * omega } else { 0.0 }, omega);
            let at = |lambda: Complex<f64>| {
                let lambda = C::new(DoubleDouble::from(lambda.re), DoubleDouble::from(lambda.im));
                exact(&structure, lambda, node, axis, decays)
            };
            let (Some(expected), Some(beside)) = (at(lambda), at(lambda * (1.0 + 1e-9))) else {
                unsure += 1;
                continue;
            };
            let found =
                if decays { damped(&structure, lambda, node, axis) } else { undamped(&structure, omega, node, axis) };
            let found = match found {
                Ok(found) => found,
                Err(error) => {
                    wrong.push(format!("{name} at {lambda}, {axis} of node {node}: {error}"));
                    continue;
                }
            };
            compared += 1;
            let condition = difference(&beside, &expected).map(|change| 1.0 + change / 1e-9);
            for (kind, error) in difference(&found, &expected).into_iter().enumerate() {
                // a reaction is a sum of forces of members, which cancel in a support that little holds
                if kind == 1 && found.1.norm() == 0.0 {
                    // no member knows what moves
                    continue;
                }
                let part = error / if kind == 0 { condition[0] } else { condition[0].max(condition[1]) };
                worst[kind] = worst[kind].max(part);
                if kind == 0 && (part > 1e-11 || part.is_nan()) || kind == 1 && (part > 1e-8 || part.is_nan()) {
                    wrong.push(format!("{name} at {lambda}, {axis} of node {node}, {kind}: {error:e}"));
                }
            }
        }
    }
    println!(
        "{compared} motions of supports, displacements {:.1e}, reactions {:.1e}, {unsure} unsure",
        worst[0], worst[1]
    );
    assert!(wrong.is_empty(), "{} of {compared}: {wrong:#?}", wrong.len());
    assert!(compared > unsure);
}

#[test]
fn motions_of_supports_are_those_of_a_stiffness_matrix() {
    judge(named_structures().into_iter(), false);
    judge(random_structures(0..20, Spread::Moderate), false);
    judge((0..12).map(|seed| (format!("damped {seed}"), damped_structure(seed))), true);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn motions_of_supports_of_hundreds_of_random_structures_are_those_of_a_stiffness_matrix() {
    judge(random_structures(0..300, Spread::Moderate), false);
    judge(random_structures(0..300, Spread::Stiff), false);
    judge((0..100).map(|seed| (format!("damped {seed}"), damped_structure(seed))), true);
}

#[test]
fn what_nothing_holds_neither_moves_nor_reacts() {
    let mut structure = Structure::default();
    let foot = structure.node(Node::at([0.0, 0.0]).held(Freedoms::PIN));
    let tip = structure.node(Node::at([1.0, 0.0]).along([1.0, 1.0]));
    let section = crate::structure::Section { axial_stiffness: 1e4, bending_stiffness: 1.0, mass_per_length: 1.0 };
    structure.beam(foot, tip, section);
    let told = asked(&structure, |network| {
        let [foot, tip] = [foot, tip].map(PlanePoint::node);
        let ask = |load| network.frequency_response(load, tip.displacement_x()).and_then(|response| response.at(0.3));
        let free = mstmm::network::Freedoms::RZ;
        assert_eq!(ask(foot.motion_z()), Err(MotionError::NotHeld { freedom: free }));
        assert!(ask(tip.motion_x()).is_ok());
        let reaction = network.frequency_response(tip.force_x(), foot.reaction_z()).map(|_| ());
        assert_eq!(reaction, Err(MotionError::NotHeld { freedom: free }));
        Ok(())
    });
    told.unwrap();
}

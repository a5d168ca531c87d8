//! Responses beside those of an independent dynamic stiffness matrix in double-double arithmetic.

use crate::families::line::line_structures;
use crate::families::random::Spread;
use crate::families::{Named, named_structures, random_structures};
use crate::oracle::Oracle;
use crate::stiffness_matrix::discs::C;
use crate::structure::Structure;
use crate::through_library::asked;
use mstmm::motion::PlanePoint;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

/// Frequencies of all sizes, off round numbers.
const OMEGAS: [f64; 6] = [0.0, 0.0137, 0.41, 3.7, 29.3, 411.0];

/// The relative change of a frequency by which the condition of a response is measured.
const STEP: f64 = 1e-9;

/// What was compared.
#[derive(Debug, Default)]
struct Tally {
    compared: usize,
    unsure: usize,
    resonant: usize,
    worst: f64,
    wrong: Vec<String>,
}

fn at(omega: f64) -> C {
    C::new(DoubleDouble::from(0.0), DoubleDouble::from(omega))
}

fn plain(values: &[[C; 3]]) -> Vec<[f64; 3]> {
    values.iter().map(|node| node.map(|value| value.re.to_f64())).collect()
}

/// The largest displacement or rotation; members have lengths of the order of 1.
fn size(values: impl IntoIterator<Item = [f64; 3]>) -> f64 {
    values.into_iter().flatten().map(f64::abs).fold(0.0, f64::max)
}

fn difference(one: &[[f64; 3]], other: &[[f64; 3]]) -> f64 {
    size(one.iter().zip(other).map(|(one, other)| [0, 1, 2].map(|k| one[k] - other[k])))
}

/// Compares the responses of a structure to a force on one of its nodes.
fn compare((name, structure): &Named, tally: &mut Tally) {
    if structure.nodes.len() > 60 || structure.members.len() > 80 {
        return;
    }
    let (oracle, moved) = (Oracle::of(structure), Oracle::of(&moved(structure)));
    for (k, omega) in OMEGAS.into_iter().enumerate() {
        let (node, axis) = ((7 * k + 1) % structure.nodes.len(), k % 3);
        let Some(exact) = oracle.response(at(omega), node, axis) else {
            tally.unsure += 1;
            continue;
        };
        let exact = plain(&exact);
        let found = match responses(structure, omega, node, axis) {
            Ok(found) => found,
            Err(error) if error.contains("resonates") || error.contains("holds") => {
                tally.resonant += 1;
                continue;
            }
            Err(error) => {
                tally.wrong.push(format!("{name} at {omega}: {error}"));
                continue;
            }
        };
        let beside = |oracle: &Oracle, omega: f64| {
            let beside = oracle.response(at(omega), node, axis);
            beside.map_or(0.0, |beside| difference(&plain(&beside), &exact))
        };
        let changes = beside(&oracle, omega * (1.0 + STEP)) + beside(&moved, omega);
        let largest = size(exact.iter().copied());
        if largest == 0.0 {
            continue;
        }
        let condition = 1.0 + changes / largest / STEP;
        let error = difference(&found, &exact) / largest / condition;
        tally.compared += 1;
        tally.worst = tally.worst.max(error);
        if error > 1e-12 || error.is_nan() {
            tally
                .wrong
                .push(format!("{name} at {omega}, load {axis} of node {node}: {error:e}, condition {condition:e}"));
        }
    }
}

/// The structure with all coordinates and directions changed by parts of the step.
fn moved(structure: &Structure) -> Structure {
    let mut changed = structure.clone();
    let mut count = 0.0;
    let mut change = |place: &mut [f64; 2]| {
        for coordinate in place {
            count += 1.0;
            *coordinate *= 1.0 + STEP * (count * core::f64::consts::SQRT_2 % 1.0 - 0.5);
        }
    };
    for node in &mut changed.nodes {
        change(&mut node.position);
        change(&mut node.centre);
        node.along.iter_mut().for_each(&mut change);
    }
    for member in &mut changed.members {
        member.along.iter_mut().for_each(&mut change);
        member.ends.iter_mut().filter_map(|end| end.position.as_mut()).for_each(&mut change);
    }
    changed
}

/// The displacements of all nodes by the library.
fn responses(structure: &Structure, omega: f64, node: usize, axis: usize) -> Result<Vec<[f64; 3]>, String> {
    asked(structure, |network| {
        let point = PlanePoint::node(node);
        let load = [point.force_x(), point.force_y(), point.torque_z()][axis];
        let response = network.frequency_response(load, point.displacement_x()).map_err(|error| error.to_string())?;
        let states = response.states(omega).map_err(|error| error.to_string())?;
        (0..structure.nodes.len()).map(|node| states.node(node).map_err(|error| error.to_string())).collect()
    })
}

fn judge(structures: impl Iterator<Item = Named>) {
    let mut tally = Tally::default();
    structures.for_each(|structure| compare(&structure, &mut tally));
    let Tally { compared, unsure, resonant, worst, wrong } = tally;
    println!(
        "{compared} responses, worst {worst:.1e} of the largest by condition, {resonant} resonant, {unsure} unsure"
    );
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(compared > unsure + resonant, "too few of them");
}

#[test]
fn responses_of_hard_structures_are_those_of_a_stiffness_matrix() {
    judge(named_structures().into_iter());
}

#[test]
fn responses_of_random_structures_are_those_of_a_stiffness_matrix() {
    judge(random_structures(0..30, Spread::Moderate).chain(random_structures(0..30, Spread::Stiff)));
}

/// Both choices of pivots round alike in one of its members.
#[test]
fn responses_that_other_pivots_do_not_doubt_are_those_of_a_stiffness_matrix() {
    judge(random_structures(265..266, Spread::Stiff));
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn responses_of_hundreds_of_random_structures_are_those_of_a_stiffness_matrix() {
    judge(random_structures(0..300, Spread::Moderate));
    judge(random_structures(0..300, Spread::Stiff));
    judge(line_structures(0..100));
}

/// In the numbers of the model a response loses the digits that the ratio of stiffnesses takes, and not many more.
#[test]
fn responses_at_speed_lose_the_ratio_of_stiffnesses() {
    let mut worst = [0.0_f64; 2];
    for (ratio, worst) in [1e3, 1e8].into_iter().zip(&mut worst) {
        let structure = crate::families::named::portal(ratio, 1.0);
        for omega in [0.0, 0.37, 2.9, 17.3, 71.0] {
            let differences = asked(&structure, |network| {
                let point = PlanePoint::node(2);
                let response = network
                    .frequency_response(point.force_x(), point.displacement_x())
                    .map_err(|error| error.to_string())?;
                let [exact, quick] = [response.at(omega), response.at_speed(omega)];
                let exact = exact.map_err(|error| error.to_string())?;
                Ok((quick.map_err(|error| error.to_string())? / exact - 1.0).abs())
            });
            *worst = worst.max(differences.unwrap());
        }
    }
    assert!(worst[0] < 1e-11 && worst[1] < 1e-6, "{worst:?}");
    assert!(worst.iter().all(|difference| *difference > 0.0), "{worst:?}");
}

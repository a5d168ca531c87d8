//! Rigid joints in the axes of their nodes, which share unknowns, beside rigid joints in other axes or at other places, whose forces are unknowns.
#![expect(clippy::unwrap_used, reason = "the structures have the nodes and members that are asked for")]

use crate::structure::{Element, End, Freedoms, Node, Section, Structure};
use crate::through_library::{asked, asked_to_decay};
use mstmm::Complex;
use mstmm::motion::{MovingNetwork, PlaneEntry, PlaneFrequency, PlaneLoad, PlanePoint, PlaneStates};
use mstmm::network::InNetwork;
use mstmm::number::{DoubleDouble, Scalar};
use mstmm::prelude::*;
use mstmm::search::System;

const SECTION: Section = Section { axial_stiffness: 900.0, bending_stiffness: 2.0, mass_per_length: 1.5 };

/// What is different in the second structure of a pair: both move alike.
#[derive(Clone, Copy, PartialEq)]
enum Axes {
    /// Those of the plane, at the nodes.
    OfNodes,
    /// Of pins others, of which each ties parts of two motions; of other joints those of the plane at another place, where all of
    /// them tie a rotation.
    Others,
}

/// Joins two nodes at one place.
fn join(structure: &mut Structure, axes: Axes, [from, to]: [usize; 2], freedoms: Freedoms) {
    let mut ends = [End::from(from), End::from(to)];
    let mut along = None;
    if axes == Axes::Others {
        if freedoms == Freedoms::PIN {
            along = Some([0.6, 0.8]);
        } else {
            assert!(freedoms.rz);
            let [x, y] = structure.nodes[from].position;
            ends = ends.map(|end| end.at([x + 0.5, y - 0.25]));
        }
    }
    structure.weld(ends[0], ends[1], freedoms);
    structure.members.last_mut().unwrap().along = along;
}

/// Joints of one node with three others, two joints in series, joints with the ground and with a roller, bodies on both sides of joints.
fn structure(axes: Axes) -> Structure {
    let mut structure = Structure::default();
    let slider_x = Freedoms::Y.union(Freedoms::RZ);
    let ground = structure.clamp([0.0, 0.0]);
    let foot = structure.node(Node::at([0.0, 0.0]));
    let corner = structure.node(Node::at([0.0, 2.0]).body(0.7, 0.2, [0.1, 2.2]));
    let hub = structure.node(Node::at([3.0, 2.0]));
    let tied = [0.0, 0.4, 0.3].map(|mass| structure.node(Node::at([3.0, 2.0]).body(mass, 0.1 * mass, [3.1, 1.9])));
    let series = structure.node(Node::at([5.0, 2.0]));
    let middle = structure.node(Node::at([5.0, 2.0]));
    let far = structure.node(Node::at([5.0, 2.0]));
    let other_ground = structure.clamp([3.0, -1.0]);
    let roller = structure.node(Node::at([6.0, 0.0]).held(Freedoms::Y));
    let on_roller = structure.node(Node::at([6.0, 0.0]));
    structure.beam(foot, corner, SECTION);
    structure.beam(corner, tied[0], SECTION.times(1.5));
    structure.beam(tied[1], other_ground, SECTION.times(0.5));
    structure.beam(tied[2], series, SECTION.times(2.0));
    structure.beam(far, on_roller, SECTION);
    structure.beam(hub, ground, SECTION.times(0.1));
    structure.torsion_spring(hub, tied[0], 0.3);
    structure.spring(corner, far, 5.0);
    for pair in [[ground, foot], [hub, tied[0]], [tied[1], hub], [hub, tied[2]]] {
        join(&mut structure, axes, pair, Freedoms::PIN);
    }
    join(&mut structure, axes, [series, middle], slider_x);
    join(&mut structure, axes, [middle, far], Freedoms::PIN);
    // the roller ties no y: its node has none
    join(&mut structure, axes, [roller, on_roller], Freedoms::X.union(Freedoms::RZ));
    structure.spring_along(on_roller, roller, [0.0, 1.0], 40.0);
    // a softer motion of the slider
    structure.spring_along(series, far, [1.0, 0.0], 20.0);
    structure
}

/// The displacements of all nodes and the forces of all members on their first ends, those of joints in the axes of the plane.
fn all<Y, S>(structure: &Structure, states: &PlaneStates<'_, Y, S>) -> Vec<[S; 3]>
where
    Y: MovingNetwork<S> + System<Parameter = f64>,
    S: PlaneFrequency<f64>,
{
    let mut numbers: Vec<_> = (0..structure.nodes.len()).map(|node| states.node(node).unwrap()).collect();
    for (index, member) in structure.members.iter().enumerate() {
        for end in states.member(index).unwrap() {
            let [x, y, mut moment] = end.forces;
            let [c, s] = member.along.unwrap_or([1.0, 0.0]).map(S::from_f64);
            let is_joint = matches!(member.element, Element::Weld { .. });
            // a moment about another place
            if let (true, Some([at_x, at_y])) = (is_joint, member.ends[0].position) {
                let [node_x, node_y] = structure.nodes[member.ends[0].node].position;
                moment += y * S::from_f64(at_x - node_x) - x * S::from_f64(at_y - node_y);
            }
            numbers.push(if is_joint { [x * c - y * s, x * s + y * c, moment] } else { end.forces });
        }
    }
    numbers
}

/// The number of a list that is largest in another one: shapes have any sign.
fn largest_of<S: PlaneFrequency<f64>>(of: &[[S; 3]], in_list: &[[S; 3]]) -> S {
    let pairs = of.iter().flatten().zip(in_list.iter().flatten());
    let (own, _) = pairs.max_by(|(_, one), (_, other)| one.modulus().total_cmp(&other.modulus())).unwrap();
    *own
}

/// The largest difference of two lists, of which each number is over the one that is largest in the first.
fn difference<S: PlaneFrequency<f64>>([one, other]: &[Vec<[S; 3]>; 2]) -> f64 {
    let [of_one, of_other] = [one, other].map(|list| largest_of(list, one));
    let pairs = one.iter().flatten().zip(other.iter().flatten());
    pairs.map(|(one, other)| (*one / of_one - *other / of_other).modulus()).fold(0.0, f64::max)
}

/// Oracle: the same joints, whose forces are unknowns of their own since each ties parts of several motions.
#[test]
fn joints_move_as_those_of_other_axes() {
    let pair = [structure(Axes::OfNodes), structure(Axes::Others)];
    let point = |node: usize| PlanePoint::<InNetwork>::node(node);
    let loads: [PlaneLoad<InNetwork>; 5] =
        [point(4).force_x(), point(5).force_y(), point(8).force_x(), PlaneLoad::self_weight_y(), point(0).motion_x()];
    let entry: PlaneEntry<InNetwork> = point(2).displacement_x();
    let mut worst = 0.0_f64;
    for load in loads {
        for omega in [0.01, 0.7, 3.1, 20.0, 90.0] {
            let lambda = Complex::new(-0.01 * omega, omega);
            let motions = pair.each_ref().map(|structure| {
                asked_to_decay(structure, |network| {
                    let response = network.frequency_response(load, entry).unwrap();
                    Ok(all(structure, &response.states(lambda).unwrap()))
                })
                .unwrap()
            });
            worst = worst.max(difference(&motions));
        }
    }
    println!("joints by rows beside joints with forces: {worst:e}");
    assert!(worst < 1e-14, "{worst:e}");
}

/// Oracle: as before. Frequencies, Δ and shapes are those of the structure.
#[test]
fn modes_of_joints_are_those_of_other_axes() {
    let pair = [structure(Axes::OfNodes), structure(Axes::Others)];
    let [one, other] = pair.each_ref().map(|structure| {
        asked(structure, |network| {
            let found = network.first_frequencies::<8>().map_err(|error| error.to_string())?;
            let roots: Vec<_> = found.iter().map(|root| root.omega).collect();
            let shape = |root| all(structure, &network.mode_shape(root).unwrap());
            let shapes: Vec<_> = found.iter().map(shape).collect();
            let omegas = (1..20).map(|k| DoubleDouble::from(1.3 * f64::from(k)));
            let deltas: Vec<_> = omegas.map(|omega| network.characteristic(omega)).collect();
            Ok((roots, shapes, deltas))
        })
        .unwrap()
    });
    for (one, other) in one.0.iter().zip(&other.0) {
        assert!((one - other).abs() <= 2.0 * f64::EPSILON * one, "{one} {other}");
    }
    let mut worst = 0.0_f64;
    for pair in one.1.into_iter().zip(other.1) {
        worst = worst.max(difference(&pair.into()));
    }
    println!("shapes of joints by rows beside joints with forces: {worst:e}");
    assert!(worst < 1e-13, "{worst:e}");
    for (one, other) in one.2.iter().zip(&other.2) {
        let [one, other] = [one, other].map(|delta| (delta.mantissa(), delta.exponent()));
        assert_eq!(one.1, other.1);
        assert!((one.0 - other.0).size() < 1e-25 * one.0.size(), "{one:?} {other:?}");
    }
}

//! Responses at rest beside beam theory, and roots that are none.
#![expect(clippy::unwrap_used, reason = "the structures are right")]

use crate::structure::{Freedoms, Node, Section, Structure};
use crate::through_library::{Undamped, asked};
use mstmm::motion::{MemberEnd, MemberLabel, MotionError, PlaneEntry, PlaneLoad, PlanePoint};
use mstmm::network::InNetwork;
use mstmm::prelude::*;

const SECTION: Section = Section { axial_stiffness: 3e4, bending_stiffness: 2.0, mass_per_length: 1.5 };

fn at_rest(structure: &Structure, load: PlaneLoad<InNetwork>, entry: PlaneEntry<InNetwork>) -> f64 {
    asked(structure, |network| {
        network.frequency_response(load, entry).and_then(|response| response.at(0.0)).map_err(|error| error.to_string())
    })
    .unwrap()
}

fn input(member: usize) -> MemberEnd<InNetwork> {
    MemberLabel::<InNetwork, ()>::member(member).input()
}

fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-13 * expected.abs(), "{found} {expected}");
}

/// A beam of a length in two parts along a direction, held at both ends.
fn beam(length: f64, [c, s]: [f64; 2], held: [Freedoms; 2]) -> Structure {
    let mut structure = Structure::default();
    let places = [0.0, 0.5, 1.0].map(|part| [part * length * c, part * length * s]);
    let from = structure.node(Node::at(places[0]).held(held[0]));
    let middle = structure.node(Node::at(places[1]));
    let to = structure.node(Node::at(places[2]).held(held[1]));
    structure.beam(from, middle, SECTION);
    structure.beam(middle, to, SECTION);
    structure
}

#[test]
fn beams_under_a_load_in_the_middle_are_those_of_the_tables() {
    let (length, ei) = (3.0, SECTION.bending_stiffness);
    let middle = PlanePoint::node(1);
    let of = |held, entry| at_rest(&beam(length, [1.0, 0.0], held), middle.force_y(), entry);
    // clamped at both ends, at one and pinned at the other, pinned at both
    let [clamped, propped, pinned] = [[Freedoms::ALL; 2], [Freedoms::ALL, Freedoms::PIN], [Freedoms::PIN; 2]];
    assert_near(of(clamped, middle.displacement_y()), length.powi(3) / (192.0 * ei));
    assert_near(of(clamped, input(0).moment()), length / 8.0);
    assert_near(of(propped, middle.displacement_y()), 7.0 * length.powi(3) / (768.0 * ei));
    assert_near(of(propped, input(0).moment()), 3.0 * length / 16.0);
    assert_near(of(propped, PlanePoint::node(2).reaction_y()), -5.0 / 16.0);
    assert_near(of(pinned, middle.displacement_y()), length.powi(3) / (48.0 * ei));
    assert_near(of(pinned, input(1).moment()), -length / 4.0);
    assert_near(of(pinned, input(0).shear()), -0.5);
}

#[test]
fn a_support_that_settles_bends_a_clamped_beam() {
    let (length, ei) = (3.0, SECTION.bending_stiffness);
    let structure = beam(length, [0.6, 0.8], [Freedoms::ALL; 2]);
    let far = PlanePoint::node(2);
    // along x it goes 0.8 across the beam and 0.6 along it
    let moment = at_rest(&structure, far.motion_x(), input(0).moment());
    assert_near(moment, 0.8 * -6.0 * ei / length.powi(2));
    assert_near(at_rest(&structure, far.motion_x(), input(0).axial_force()), 0.6 * SECTION.axial_stiffness / length);
    assert_near(at_rest(&structure, far.motion_z(), input(0).moment()), -2.0 * ei / length);
    assert_near(at_rest(&structure, far.motion_z(), far.reaction_z()), 4.0 * ei / length);
}

#[test]
fn two_bars_carry_a_load_along_themselves() {
    let mut structure = Structure::default();
    let foot = structure.clamp([0.0, 0.0]);
    let other_foot = structure.clamp([2.0, 0.0]);
    let top = structure.node(Node::at([1.0, 2.0]));
    structure.spring(foot, top, 700.0);
    structure.spring(other_foot, top, 700.0);
    // nothing else knows of the rotation of the top
    structure.torsion_spring(top, foot, 1.0);
    let length = 5.0_f64.sqrt();
    // each carries half of the load over the sine of its angle
    let axial = at_rest(&structure, PlanePoint::node(top).force_y(), input(0).axial_force());
    assert_near(axial, 0.5 * length / 2.0);
    let deflection = at_rest(&structure, PlanePoint::node(top).force_y(), PlanePoint::node(top).displacement_y());
    assert_near(deflection, axial / 700.0 * length / 2.0);
}

#[test]
fn a_multiple_root_of_another_structure_is_none() {
    let square = |free: bool, side: f64| {
        let mut structure = Structure::default();
        let middle = structure.node(Node::at([0.0, 0.0]));
        for [x, y] in [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]] {
            let held = if free { Freedoms::NONE } else { Freedoms::ALL };
            let node = structure.node(Node::at([side * x, side * y]).held(held));
            structure.beam(middle, node, SECTION);
        }
        structure
    };
    let roots = |structure: &Structure| {
        asked(structure, |network: &Undamped| {
            Ok(network.first_frequencies::<8>().map_err(|error| error.to_string())?.to_vec())
        })
        .unwrap()
    };
    let (held, other) = (square(false, 1.0), square(false, 1.1));
    let multiple: Vec<_> = roots(&held).into_iter().filter(|root| root.multiplicity > 1).collect();
    assert!(!multiple.is_empty());
    let at_rest = roots(&square(true, 1.0)).into_iter().find(|root| root.omega == 0.0).unwrap();
    assert_eq!(at_rest.multiplicity, 3);
    for root in multiple.iter().chain([&at_rest]) {
        let told = asked(&other, |network| Ok(network.mode_shapes::<4, _>(root).map(|shapes| shapes.iter().count())));
        assert!(matches!(told, Ok(Err(MotionError::NotARoot { .. }))), "{told:?}");
    }
    let own = asked(&held, |network| Ok(network.mode_shapes::<4, _>(&multiple[0]).map(|shapes| shapes.iter().count())));
    assert_eq!(own, Ok(Ok(multiple[0].multiplicity as usize)));
}

/// A load on what is held goes into the support at once.
#[test]
fn a_support_takes_the_load_on_its_point() {
    let structure = beam(2.0, [0.6, 0.8], [Freedoms::ALL, Freedoms::NONE]);
    let foot = PlanePoint::node(0);
    assert_near(at_rest(&structure, foot.force_x(), foot.reaction_x()), -1.0);
    assert_near(at_rest(&structure, foot.torque_z(), foot.reaction_z()), -1.0);
    let tip = PlanePoint::node(2);
    assert_near(at_rest(&structure, tip.force_y(), foot.reaction_y()), -1.0);
    assert_near(at_rest(&structure, tip.force_y(), foot.reaction_z()), -1.2);
}

/// A point that springs hold along one line alone may go across it, at any frequency.
#[test]
fn a_mechanism_is_named_and_no_resonance() {
    let mut structure = Structure::default();
    let clamp = structure.clamp([0.0, 0.0]);
    let tip = structure.node(Node::at([1.0, 0.0]));
    let free = structure.node(Node::at([2.0, 0.0]).held(Freedoms::RZ));
    let wall = structure.clamp([3.0, 0.0]);
    structure.beam(clamp, tip, SECTION);
    structure.spring(tip, free, 5.0);
    structure.spring(free, wall, 5.0);
    let told = asked(&structure, |network| {
        let point = PlanePoint::node(tip);
        let response = network.frequency_response(point.force_x(), point.displacement_x()).unwrap();
        Ok([0.0, 1.0, 100.0]
            .map(|omega| response.at(omega))
            .into_iter()
            .chain([response.at(1e300), response.at(f64::NAN)])
            .collect::<Vec<_>>())
    });
    let told = told.unwrap();
    assert!(told[..3].iter().all(|told| matches!(told, Err(MotionError::Mechanism { .. }))), "{told:?}");
    assert!(told[3..].iter().all(|told| matches!(told, Err(MotionError::NotFinite { .. }))), "{told:?}");
}

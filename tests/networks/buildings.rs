//! A building whose answers need more memory than a small stack has.

use mstmm::motion::{MemberLabel, PlaneLoad, PlanePoint};
use mstmm::network::{InNetwork, Member, Network, Node, Room, Section, Support, UndampedMember};
use mstmm::prelude::*;
use std::thread::Builder;

const BAYS: usize = 10;
const STOREYS: usize = 9;
const NODES: usize = (BAYS + 1) * (STOREYS + 1);
const MEMBERS: usize = (2 * BAYS + 1) * STOREYS;

/// Unknowns at once.
const WIDTH: usize = 45;

/// The stack of a thread \[bytes\].
const STACK: usize = 2 << 20;

const SECTION: Section<f64> = Section { axial_stiffness: 1.26e9, bending_stiffness: 5.25e6, mass_per_length: 47.1 };

fn node(level: usize, column: usize) -> usize {
    level * (BAYS + 1) + column
}

/// Columns and girders, those of a storey one after the other.
fn members() -> Vec<Member<UndampedMember<f64>>> {
    let beam = |from, to| Member::new(from, to, SECTION);
    let column = |level: usize, column: usize| beam(node(level - 1, column), node(level, column));
    let girder = |level: usize, column: usize| beam(node(level, column - 1), node(level, column));
    let storey =
        |level: usize| (0..=BAYS).map(move |k| column(level, k)).chain((1..=BAYS).map(move |k| girder(level, k)));
    (1..=STOREYS).flat_map(storey).collect()
}

type Building<'a> = Network<'a, UndampedMember<f64>, WIDTH, NODES, MEMBERS>;

/// Asks a building a question on a thread of its own with a small stack.
fn ask(question: fn(&Building<'_>)) {
    let asked = move || {
        let place = |number: usize| [5.0 * (number % (BAYS + 1)) as f64, 3.0 * (number / (BAYS + 1)) as f64];
        let clamp = Support::Fixed.holds();
        let node = |number: usize| {
            let node = Node::at(place(number));
            if number <= BAYS { node.held(clamp) } else { node }
        };
        let mut room = Box::new(Room::<_, NODES, MEMBERS>::new());
        let nodes: Vec<_> = (0..NODES).map(node).collect();
        let members = members();
        let building = Network::new(&nodes, &members, &mut room);
        question(&building.unwrap_or_else(|error| unreachable!("{error}")));
    };
    let thread = Builder::new().stack_size(STACK).spawn(asked);
    assert!(thread.is_ok_and(|thread| thread.join().is_ok()));
}

/// The upper corner of a column.
fn top(column: usize) -> PlanePoint<InNetwork> {
    PlanePoint::node(node(STOREYS, column))
}

#[test]
#[ignore = "large: in .ci/long"]
fn shapes_of_a_building_fit_on_a_small_stack() {
    ask(|building| {
        let roots = building.first_frequencies::<2>().unwrap();
        assert!(roots.iter().all(|root| root.is_proven), "{roots:?}");
        let [first, second] = [0, 1].map(|mode| Box::new(building.mode_shape(&roots[mode]).unwrap()));
        assert!((first.modal_mass() - 1.0).abs() < 1e-12);
        assert!(first.product(&second).abs() < 1e-9);
    });
}

/// Force and displacement change places.
#[test]
#[ignore = "large: in .ci/long"]
fn responses_of_a_building_fit_on_a_small_stack() {
    ask(|building| {
        let one = building.frequency_response(top(0).force_x(), top(BAYS).displacement_x()).unwrap();
        let other = building.frequency_response(top(BAYS).force_x(), top(0).displacement_x()).unwrap();
        assert!((one.at(3.0).unwrap() / other.at(3.0).unwrap() - 1.0).abs() < 1e-14);
        let lambda = Complex::new(-0.1, 3.0);
        assert!((one.at(lambda).unwrap() / other.at(lambda).unwrap() - 1.0).norm() < 1e-14);
    });
}

/// The feet carry the weight.
#[test]
#[ignore = "large: in .ci/long"]
fn reactions_of_a_building_fit_on_a_small_stack() {
    ask(|building| {
        let carried = |foot: usize| {
            let axial = MemberLabel::<InNetwork, ()>::member(foot).input().axial_force();
            building.frequency_response(PlaneLoad::self_weight_y(), axial).unwrap().at(0.0).unwrap()
        };
        let total: f64 = (0..=BAYS).map(carried).sum();
        let weight = SECTION.mass_per_length * ((BAYS + 1) as f64 * 3.0 + BAYS as f64 * 5.0) * STOREYS as f64;
        assert!((total.abs() / weight - 1.0).abs() < 1e-12, "{total} of {weight}");
    });
}

#[test]
#[ignore = "large: in .ci/long"]
fn a_step_of_a_building_in_time_fits_on_a_small_stack() {
    ask(|building| {
        let roots = building.first_frequencies::<3>().unwrap();
        let in_time = building.modal_response::<3, _>(&roots, top(0).force_x(), top(BAYS).displacement_x()).unwrap();
        let after = in_time.to_step(0.5);
        assert!(after > 0.0 && after < 3.0 * in_time.static_value().unwrap(), "{after}");
    });
}

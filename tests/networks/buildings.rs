//! Buildings whose answers need more memory than a small stack has.

use mstmm::motion::{MemberLabel, PlaneLoad, PlanePoint};
use mstmm::network::{InNetwork, Member, Network, Node, Section, Support, UndampedMember, Vectors};
use mstmm::prelude::*;
use std::thread::Builder;

/// The stack of a thread \[bytes\].
const STACK: usize = 2 << 20;

const SECTION: Section<f64> = Section { axial_stiffness: 1.26e9, bending_stiffness: 5.25e6, mass_per_length: 47.1 };

/// A building of so many bays and storeys.
#[derive(Clone, Copy)]
struct Building {
    bays: usize,
    storeys: usize,
}

const OFFICE: Building = Building { bays: 10, storeys: 9 };
const TOWER: Building = Building { bays: 30, storeys: 60 };

impl Building {
    fn node(self, level: usize, column: usize) -> usize {
        level * (self.bays + 1) + column
    }

    /// The upper corner of a column.
    fn top(self, column: usize) -> PlanePoint<InNetwork> {
        PlanePoint::node(self.node(self.storeys, column))
    }

    fn nodes(self) -> Vec<Node<f64>> {
        let columns = self.bays + 1;
        let place = |number: usize| [5.0 * (number % columns) as f64, 3.0 * (number / columns) as f64];
        let foot = |number: usize| Node::at(place(number)).held(Support::Fixed.holds());
        let node = |number: usize| if number < columns { foot(number) } else { Node::at(place(number)) };
        (0..columns * (self.storeys + 1)).map(node).collect()
    }

    /// Columns and girders, those of a storey one after the other.
    fn members(self) -> Vec<Member<UndampedMember<f64>>> {
        let beam = |from, to| Member::new(from, to, SECTION);
        let column = |level: usize, column: usize| beam(self.node(level - 1, column), self.node(level, column));
        let girder = |level: usize, column: usize| beam(self.node(level, column - 1), self.node(level, column));
        let storey = |level: usize| {
            (0..=self.bays).map(move |k| column(level, k)).chain((1..=self.bays).map(move |k| girder(level, k)))
        };
        (1..=self.storeys).flat_map(storey).collect()
    }

    /// Asks it a question on a thread of its own with a small stack.
    fn ask(self, question: Question) -> Told {
        let asked = move || question(self, &Network::new(&self.nodes(), &self.members())?);
        match Builder::new().stack_size(STACK).spawn(asked)?.join() {
            Ok(told) => told,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    }
}

type Told = Result<(), Box<dyn std::error::Error + Send + Sync>>;
type Question = fn(Building, &Network<UndampedMember<f64>, Vectors>) -> Told;

const SHAPES_ARE_ORTHOGONAL: Question = |_, network| {
    let roots = network.first_frequencies::<2>()?;
    assert!(roots.iter().all(|root| root.is_proven), "{roots:?}");
    let (first, second) = (network.mode_shape(&roots[0])?, network.mode_shape(&roots[1])?);
    assert!((first.modal_mass() - 1.0).abs() < 1e-12);
    assert!(first.product(&second).abs() < 1e-9);
    Ok(())
};

/// Force and displacement change places.
const RESPONSES_ARE_RECIPROCAL: Question = |building, network| {
    let [near, far] = [building.top(0), building.top(building.bays)];
    let one = network.frequency_response(near.force_x(), far.displacement_x())?;
    let other = network.frequency_response(far.force_x(), near.displacement_x())?;
    assert!((one.at(3.0)? / other.at(3.0)? - 1.0).abs() < 1e-14);
    let lambda = Complex::new(-0.1, 3.0);
    assert!((one.at(lambda)? / other.at(lambda)? - 1.0).norm() < 1e-14);
    Ok(())
};

const FEET_CARRY_THE_WEIGHT: Question = |building, network| {
    let Building { bays, storeys } = building;
    let mut total = 0.0;
    for foot in 0..=bays {
        let axial = MemberLabel::<InNetwork, ()>::member(foot).input().axial_force();
        total += network.frequency_response(PlaneLoad::self_weight_y(), axial)?.at(0.0)?;
    }
    let weight = SECTION.mass_per_length * ((bays + 1) as f64 * 3.0 + bays as f64 * 5.0) * storeys as f64;
    assert!((total.abs() / weight - 1.0).abs() < 1e-12, "{total} of {weight}");
    Ok(())
};

const STEPS_IN_TIME: Question = |building, network| {
    let roots = network.first_frequencies::<3>()?;
    let (load, entry) = (building.top(0).force_x(), building.top(building.bays).displacement_x());
    let in_time = network.modal_response::<3, _>(&roots, load, entry)?;
    let after = in_time.to_step(0.5);
    assert!(after > 0.0 && after < 3.0 * in_time.static_value()?, "{after}");
    Ok(())
};

macro_rules! on_a_small_stack {
    ($($test:ident: $building:ident $question:ident;)*) => {$(
        #[test]
        #[ignore = "large: in .ci/long"]
        fn $test() -> Told {
            $building.ask($question)
        }
    )*};
}

on_a_small_stack! {
    shapes_of_an_office: OFFICE SHAPES_ARE_ORTHOGONAL;
    responses_of_an_office: OFFICE RESPONSES_ARE_RECIPROCAL;
    reactions_of_an_office: OFFICE FEET_CARRY_THE_WEIGHT;
    a_step_of_an_office_in_time: OFFICE STEPS_IN_TIME;
    shapes_of_a_tower: TOWER SHAPES_ARE_ORTHOGONAL;
    responses_of_a_tower: TOWER RESPONSES_ARE_RECIPROCAL;
    reactions_of_a_tower: TOWER FEET_CARRY_THE_WEIGHT;
    a_step_of_a_tower_in_time: TOWER STEPS_IN_TIME;
}

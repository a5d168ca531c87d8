//! Structures as the library takes them, and its answers as tests compare them.

use crate::checks::Found;
use crate::structure::{Element, Freedoms, Structure};
use mstmm::elements::{Spring, TorsionSpring};
use mstmm::network::{self, End, Member, Network, Node, Room, UndampedMember};
use mstmm::prelude::*;

/// Variables of the widest front.
const WIDTH: usize = 60;

/// Sizes of the largest structure.
const NODES: usize = 100;
const MEMBERS: usize = 160;

/// A network of the library.
pub(crate) type Undamped<'a> = Network<'a, UndampedMember<f64>, WIDTH>;

fn freedoms(set: Freedoms) -> network::Freedoms {
    let all = [(set.x, network::Freedoms::X), (set.y, network::Freedoms::Y), (set.rz, network::Freedoms::RZ)];
    all.iter().filter(|(is_in, _)| *is_in).fold(network::Freedoms::NONE, |sum, (_, one)| sum.union(*one))
}

fn nodes(structure: &Structure) -> Vec<Node<f64>> {
    let node = |node: &crate::structure::Node| {
        let other = Node::at(node.position).held(freedoms(node.held)).with_body(node.mass, node.inertia, node.centre);
        node.along.map_or(other, |direction| other.along(direction))
    };
    structure.nodes.iter().map(node).collect()
}

fn members(structure: &Structure) -> Vec<Member<UndampedMember<f64>>> {
    let member = |member: &crate::structure::Member| {
        let [from, to] = member.ends.map(|end| {
            let other = End::of(end.node).releasing(freedoms(end.released));
            end.position.map_or(other, |position| other.at(position))
        });
        let element: UndampedMember<f64> = match member.element {
            Element::Beam(section) => network::Section {
                axial_stiffness: section.axial_stiffness,
                bending_stiffness: section.bending_stiffness,
                mass_per_length: section.mass_per_length,
            }
            .into(),
            Element::Spring { stiffness } => Spring { stiffness }.into(),
            Element::TorsionSpring { stiffness } => TorsionSpring { stiffness }.into(),
            Element::Damper { .. } | Element::TorsionDamper { .. } => {
                unreachable!("undamped structures have no dashpot")
            }
        };
        let other = Member::new(from, to, element);
        member.along.map_or(other, |direction| other.along(direction))
    };
    structure.members.iter().map(member).collect()
}

/// Asks the library about a structure.
pub(crate) fn asked<R>(
    structure: &Structure,
    ask: impl FnOnce(&Undamped<'_>) -> Result<R, String>,
) -> Result<R, String> {
    let (nodes, members) = (nodes(structure), members(structure));
    let mut room = Box::new(Room::<_, NODES, MEMBERS>::new());
    let network = Undamped::new(&nodes, &members, &mut room).map_err(|error| error.to_string())?;
    ask(&network)
}

/// The first frequencies.
pub(crate) fn first(structure: &Structure) -> Result<Vec<Found>, String> {
    asked(structure, |network| {
        let found = network.first_frequencies::<10>().map_err(|error| error.to_string())?;
        let entry = |root: &NaturalFrequency<f64>| Found {
            omega: root.omega,
            lower: root.lower,
            upper: root.upper,
            multiplicity: root.multiplicity,
        };
        Ok(found.iter().map(entry).collect())
    })
}

/// The number of frequencies below one.
pub(crate) fn count(structure: &Structure, omega: f64) -> Result<u64, String> {
    asked(structure, |network| network.count_below(omega).map_err(|error| error.to_string()))
}

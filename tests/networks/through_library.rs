//! Structures as the library takes them, and its answers as tests compare them.

use crate::checks::Found;
use crate::structure::{Element, Freedoms, Section, Structure};
use mstmm::elements::{Damper, PlanarHinge, Spring, TorsionDamper, TorsionSpring};
use mstmm::network::{self, AnyMember, End, Joint, Member, MemberElement, Network, Node, UndampedMember, Vectors};
use mstmm::number::{DoubleDouble, Scaled};
use mstmm::prelude::*;
use mstmm::search::{FrequencyList, SearchError};

/// A network of the library.
pub(crate) type Undamped = Network<UndampedMember<f64>, Vectors>;

pub(crate) fn freedoms(set: Freedoms) -> network::Freedoms {
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

fn section(section: Section) -> network::Section<f64> {
    network::Section {
        axial_stiffness: section.axial_stiffness,
        bending_stiffness: section.bending_stiffness,
        mass_per_length: section.mass_per_length,
    }
}

fn hinge([stiffness_x, stiffness_y, stiffness_theta]: [f64; 3]) -> Joint<f64> {
    Joint::from(PlanarHinge { stiffness_x, stiffness_y, stiffness_theta })
}

fn undamped<E>(element: Element) -> E
where
    E: From<network::Section<f64>> + From<Spring<f64>> + From<TorsionSpring<f64>> + From<Joint<f64>>,
{
    match element {
        Element::Beam(beam) => section(beam).into(),
        Element::Spring { stiffness } => Spring { stiffness }.into(),
        Element::TorsionSpring { stiffness } => TorsionSpring { stiffness }.into(),
        Element::Hinge { stiffness } => hinge(stiffness).into(),
        Element::Weld { freedoms: shared } => Joint::rigid(freedoms(shared)).into(),
        Element::Damper { .. } | Element::TorsionDamper { .. } => unreachable!("undamped structures have no dashpot"),
    }
}

fn any(element: Element) -> AnyMember<f64> {
    match element {
        Element::Damper { damping } => Damper { damping }.into(),
        Element::TorsionDamper { damping } => TorsionDamper { damping }.into(),
        undamped_element => undamped(undamped_element),
    }
}

fn members<E: MemberElement<Parameter = f64>>(structure: &Structure, element: impl Fn(Element) -> E) -> Vec<Member<E>> {
    let member = |member: &crate::structure::Member| {
        let [from, to] = member.ends.map(|end| {
            let other = End::of(end.node).releasing(freedoms(end.released));
            end.position.map_or(other, |position| other.at(position))
        });
        let other = Member::new(from, to, element(member.element));
        member.along.map_or(other, |direction| other.along(direction))
    };
    structure.members.iter().map(member).collect()
}

/// Asks the library about a structure.
pub(crate) fn asked<R>(structure: &Structure, ask: impl FnOnce(&Undamped) -> Result<R, String>) -> Result<R, String> {
    let (nodes, members) = (nodes(structure), members(structure, undamped));
    let network = Undamped::new(&nodes, &members).map_err(|error| error.to_string())?;
    ask(&network)
}

/// The eigenvalues of least modulus, or those in a region with their number there.
pub(crate) fn eigenvalues(
    structure: &Structure,
    region: Option<Region>,
) -> Result<(Vec<Eigenvalue>, Option<u64>), String> {
    let (nodes, members) = (nodes(structure), members(structure, any));
    let network = Network::new(&nodes, &members).map_err(|error| error.to_string())?;
    let Some(region) = region else {
        let found = network.first_eigenvalues::<12>().map_err(|error| error.to_string());
        return found.map(|found| (found.to_vec(), None));
    };
    let count = network.count_in(region.clone()).map_err(|error| format!("count: {error}"))?;
    let found = network.eigenvalues::<64>(region).map_err(|error| error.to_string())?;
    Ok((found.to_vec(), Some(count)))
}

/// Δ in twice the digits.
pub(crate) fn characteristic(structure: &Structure, omegas: &[f64]) -> Result<Vec<Scaled<DoubleDouble>>, String> {
    asked(structure, |network| {
        Ok(omegas.iter().map(|&omega| network.characteristic(DoubleDouble::from(omega))).collect())
    })
}

/// The largest number of unknowns at once.
pub(crate) fn width(structure: &Structure) -> usize {
    let (nodes, members) = (nodes(structure), members(structure, undamped));
    Undamped::new(&nodes, &members).unwrap_or_else(|error| unreachable!("{error}")).unknowns_at_once()
}

fn entry(root: &NaturalFrequency<f64>) -> Found {
    Found { omega: root.omega, lower: root.lower, upper: root.upper, multiplicity: root.multiplicity }
}

/// The first frequencies.
pub(crate) fn first(structure: &Structure) -> Result<Vec<Found>, String> {
    Ok(first_by(structure)?.0)
}

/// The first frequencies, and the number of evaluations that they took.
pub(crate) fn first_by(structure: &Structure) -> Result<(Vec<Found>, usize), String> {
    let list = first_list(structure)?.map_err(|error| error.to_string())?;
    Ok((entries(&list), list.evaluations()))
}

/// The list of the first frequencies, or why there is none; an error of its own where the structure is no network.
pub(crate) fn first_list(structure: &Structure) -> Result<Result<FrequencyList<f64, 10>, SearchError>, String> {
    asked(structure, |network| Ok(network.first_frequencies::<10>()))
}

/// Entries of a list as tests compare them.
pub(crate) fn entries<const N: usize>(list: &FrequencyList<f64, N>) -> Vec<Found> {
    list.iter().map(entry).collect()
}

/// The frequencies in a range, and the number of evaluations that they took.
pub(crate) fn in_range(
    structure: &Structure,
    range: core::ops::RangeInclusive<f64>,
) -> Result<(Vec<Found>, usize), String> {
    asked(structure, |network| {
        let found = network.natural_frequencies::<400>(range).map_err(|error| error.to_string())?;
        Ok((found.iter().map(entry).collect(), found.evaluations()))
    })
}

/// The number of frequencies below one.
pub(crate) fn count(structure: &Structure, omega: f64) -> Result<u64, String> {
    asked(structure, |network| network.count_below(omega).map_err(|error| error.to_string()))
}

/// A network with dampers.
pub(crate) type Decaying = Network<AnyMember<f64>, Vectors>;

/// Asks the library about motions of a damped structure.
pub(crate) fn asked_to_decay<R>(
    structure: &Structure,
    ask: impl FnOnce(&Decaying) -> Result<R, String>,
) -> Result<R, String> {
    let (nodes, members) = (nodes(structure), members(structure, any));
    let network = Decaying::new(&nodes, &members).map_err(|error| error.to_string())?;
    ask(&network)
}

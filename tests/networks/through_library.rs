//! Structures as the library takes them.

use crate::structure::{Element, Freedoms, Structure};
use mstmm::network::{self, End, FrameBeam, Member, Node, Spring, TorsionSpring};

fn freedoms(set: Freedoms) -> network::Freedoms {
    let all = [(set.x, network::Freedoms::X), (set.y, network::Freedoms::Y), (set.rz, network::Freedoms::RZ)];
    all.iter().filter(|(is_in, _)| *is_in).fold(network::Freedoms::NONE, |sum, (_, one)| sum.union(*one))
}

/// The nodes and members of a structure, in its order; a function makes the element of a dashpot, if there may be one.
pub(crate) fn through_library<E>(
    structure: &Structure,
    dashpot: impl Fn(&Element) -> E,
) -> (Vec<Node<f64>>, Vec<Member<f64, E>>)
where
    E: From<FrameBeam<f64>> + From<Spring<f64>> + From<TorsionSpring<f64>>,
{
    let nodes = structure.nodes.iter().map(|node| {
        let other = Node::at(node.position).held(freedoms(node.held)).body(node.mass, node.inertia, node.centre);
        node.along.map_or(other, |direction| other.along(direction))
    });
    let members = structure.members.iter().map(|member| {
        let [from, to] = member.ends.map(|end| {
            let other = End::of(end.node).releasing(freedoms(end.released));
            end.position.map_or(other, |position| other.at(position))
        });
        let element: E = match &member.element {
            Element::Beam(section) => FrameBeam {
                axial_stiffness: section.axial_stiffness,
                bending_stiffness: section.bending_stiffness,
                mass_per_length: section.mass_per_length,
            }
            .into(),
            Element::Spring { stiffness } => Spring { stiffness: *stiffness }.into(),
            Element::TorsionSpring { stiffness } => TorsionSpring { stiffness: *stiffness }.into(),
            other => dashpot(other),
        };
        let other = Member::new(from, to, element);
        member.along.map_or(other, |direction| other.along(direction))
    });
    (nodes.collect(), members.collect())
}

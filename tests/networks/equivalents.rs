//! The same structure written otherwise.

use crate::structure::{Element, End, Freedoms, Member, Node, Structure};
use crate::support::random_tree::Random;

/// Every beam as two halves. Where positions are multiples of powers of two the middle is exact.
pub(crate) fn in_halves(structure: &Structure) -> Structure {
    let mut other = Structure { nodes: structure.nodes.clone(), members: Vec::new() };
    for member in &structure.members {
        let Element::Beam(section) = member.element else {
            other.members.push(*member);
            continue;
        };
        let [[x, y], [x_out, y_out]] = member.ends.map(|end| structure.position(&end));
        let middle = other.node(Node::at([0.5 * (x + x_out), 0.5 * (y + y_out)]));
        let [from, to] = member.ends;
        other.beam(from, middle, section);
        other.beam(middle, to, section);
    }
    other
}

/// Turned by the angle of the sides 3 and 4 of a right triangle, five times as large, all forces and masses five times as large:
/// the frequencies are the same.
pub(crate) fn turned(structure: &Structure) -> Structure {
    let turn = |[x, y]: [f64; 2]| [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y];
    let node = |node: &Node| {
        let free = match node.held {
            Freedoms { x: true, y: false, .. } => Some([0.0, 1.0]),
            Freedoms { x: false, y: true, .. } => Some([1.0, 0.0]),
            _ => node.along,
        };
        let rotation = Freedoms { rz: node.held.rz, ..Freedoms::NONE };
        Node {
            position: turn(node.position),
            held: if free.is_some() { rotation } else { node.held },
            along: free.map(turn),
            mass: 5.0 * node.mass,
            inertia: 125.0 * node.inertia,
            centre: turn(node.centre),
        }
    };
    let end = |end: End| End { position: end.position.map(turn), ..end };
    let member = |member: &Member| Member {
        ends: member.ends.map(end),
        along: member.along.map(turn),
        element: match member.element {
            Element::Beam(mut section) => {
                section.axial_stiffness *= 25.0;
                section.bending_stiffness *= 625.0;
                Element::Beam(section)
            }
            Element::Spring { stiffness } => Element::Spring { stiffness: 5.0 * stiffness },
            Element::TorsionSpring { stiffness } => Element::TorsionSpring { stiffness: 125.0 * stiffness },
            Element::Hinge { stiffness: [along, across, rotation] } => {
                Element::Hinge { stiffness: [5.0 * along, 5.0 * across, 125.0 * rotation] }
            }
            Element::Weld { freedoms } => Element::Weld { freedoms },
            Element::Damper { damping } => Element::Damper { damping: 5.0 * damping },
            Element::TorsionDamper { damping } => Element::TorsionDamper { damping: 125.0 * damping },
        },
    };
    Structure {
        nodes: structure.nodes.iter().map(node).collect(),
        members: structure.members.iter().map(member).collect(),
    }
}

/// All nodes and members in the opposite order, and each member from its other end.
pub(crate) fn reversed(structure: &Structure) -> Structure {
    let last = structure.nodes.len() - 1;
    let end = |end: End| End { node: last - end.node, ..end };
    let member = |member: &Member| {
        let [from, to] = member.ends.map(end);
        Member { ends: [to, from], ..*member }
    };
    Structure {
        nodes: structure.nodes.iter().rev().copied().collect(),
        members: structure.members.iter().rev().map(member).collect(),
    }
}

/// Numbers from zero on in a random order.
fn shuffled(random: &mut Random, count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    for index in (1..count).rev() {
        order.swap(index, random.below(index + 1));
    }
    order
}

/// Nodes and members in a random order, half of the members from their other end.
pub(crate) fn shuffled_structure(structure: &Structure, seed: u64) -> Structure {
    let mut random = Random(seed);
    let order = shuffled(&mut random, structure.nodes.len());
    let mut places = vec![0; order.len()];
    order.iter().enumerate().for_each(|(place, &node)| places[node] = place);
    let end = |end: End| End { node: places[end.node], ..end };
    let mut members = Vec::new();
    for index in shuffled(&mut random, structure.members.len()) {
        let member = structure.members[index];
        let [from, to] = member.ends.map(end);
        let ends = if random.chance(0.5) { [to, from] } else { [from, to] };
        members.push(Member { ends, ..member });
    }
    Structure { nodes: order.into_iter().map(|node| structure.nodes[node]).collect(), members }
}

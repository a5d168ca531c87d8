//! The visit of a network for the proof: members in the order in which they join, nodes in that in which they leave.

use crate::element::MemberNumbers;
use crate::number::Parameter;
use crate::pass::network::placed::Placed;
use crate::pass::network::placed_node::XYZ;
use crate::proof::visit::{MemberEnd, NodeNumbers, Visitor};
use mstmm_plan::Freedoms;

/// Names the members and nodes of a network.
pub fn visit_network<Y: Placed>(network: &Y, visitor: &mut dyn Visitor) {
    let order = network.order();
    for &node in order.nodes {
        let ends = order.incidence.ends(node);
        // joints behind all others: what they tie has its stiffness then
        let (mut are_joints, mut has_joints) = (false, true);
        while has_joints {
            has_joints = false;
            for &end in ends.iter().filter(|&&end| order.is_first_at(end, node)) {
                let member = end / 2;
                let numbers = &network.numbers()[member];
                if matches!(numbers, MemberNumbers::Joint(..)) == are_joints {
                    let ends = [end_of(network, member, 0), end_of(network, member, 1)];
                    let placement = network.placement(member);
                    let plane = placement.plane().map(Y::Parameter::words);
                    visitor.member((member, placement.freedoms, plane), numbers, &ends, node);
                } else {
                    has_joints = !are_joints;
                }
            }
            are_joints = true;
        }
        let own = network.node(node).0;
        if own.has_body() {
            let centre = own.centre.map(Y::Parameter::words);
            let inertia = own.inertia.map(Y::Parameter::words);
            visitor.body(&node_of(network, node), own.mass.words(), &inertia, centre);
        }
        visitor.leave(node);
    }
}

/// A node in numbers.
fn node_of<Y: Placed>(network: &Y, index: usize) -> NodeNumbers {
    let node = network.node(index).0;
    let skew = node.skew.map(|skew| skew.map(Y::Parameter::words));
    let held = if skew.is_some() { node.held.union(XYZ) } else { node.held };
    NodeNumbers { index, place: node.position.map(Y::Parameter::words), free: Freedoms::SPACE.without(held), skew }
}

/// The end of a member in numbers.
fn end_of<Y: Placed>(network: &Y, member: usize, end: usize) -> MemberEnd {
    let placement = network.placement(member);
    MemberEnd {
        node: node_of(network, placement.node_of(end)),
        place: placement.place_of(end).map(Y::Parameter::words),
        along: placement.along(end).map(|direction| direction.map(Y::Parameter::words)),
        released: placement.released(end),
    }
}

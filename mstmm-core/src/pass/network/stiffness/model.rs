//! A network in numbers alone, as the stiffness pass reads it.

use crate::element::MemberNumbers;
use crate::number::Real;
use crate::pass::network::member::Placement;
use crate::pass::network::node::{Motions, Node};
use crate::pass::network::stiffness::arrangement::arrange;
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::node::StiffnessNode;
use mstmm_plan::NetworkOrder;

/// Memory for a network in numbers, in the order in which a pass needs them.
#[derive(Clone, Debug)]
pub(crate) struct StiffnessRoom<const NODES: usize, const MEMBERS: usize> {
    nodes: [StiffnessNode; NODES],
    members: [StiffnessMember; MEMBERS],
    /// The parameters of members, from which a proof computes them anew.
    numbers: [MemberNumbers; MEMBERS],
    joining: [u32; MEMBERS],
    parting: [u32; MEMBERS],
    width: Option<usize>,
}

impl<const NODES: usize, const MEMBERS: usize> StiffnessRoom<NODES, MEMBERS> {
    /// Memory without a network.
    pub(crate) fn new() -> Self {
        StiffnessRoom {
            nodes: [StiffnessNode::none(); NODES],
            members: [StiffnessMember::none(); MEMBERS],
            numbers: [MemberNumbers::Other; MEMBERS],
            joining: [0; MEMBERS],
            parting: [0; MEMBERS],
            width: None,
        }
    }

    /// Keeps a node.
    pub(crate) fn set_node<T: Real>(&mut self, index: usize, node: &Node<T>, motions: &Motions<T>) {
        self.nodes[index] = StiffnessNode::new(node, motions);
    }

    /// Keeps a member in its place.
    pub(crate) fn set_member<T: Real>(&mut self, index: usize, numbers: MemberNumbers, placement: &Placement<T>) {
        self.members[index] = StiffnessMember::new(&numbers, placement);
        self.numbers[index] = numbers;
    }

    /// Arranges all that was kept for the passes to come.
    pub(crate) fn arrange(&mut self, order: &NetworkOrder<'_>) {
        let StiffnessRoom { nodes, members, joining, parting, width, .. } = self;
        *width = arrange(order, nodes, members, [joining, parting]);
    }

    /// The members in numbers.
    pub(crate) fn numbers(&self) -> &[MemberNumbers] {
        &self.numbers
    }

    /// The network, given its order, unless a member is not known in numbers, or too many displacements are in a front.
    pub(crate) fn model<'a>(&'a self, order: &NetworkOrder<'a>) -> Option<StiffnessModel<'a>> {
        let StiffnessRoom { nodes, members, joining, parting, width, .. } = self;
        (*width).map(|width| StiffnessModel { nodes, members, order: order.nodes, joining, parting, width })
    }
}

/// A network in numbers.
#[derive(Clone, Copy, Debug)]
pub struct StiffnessModel<'a> {
    pub(super) nodes: &'a [StiffnessNode],
    pub(super) members: &'a [StiffnessMember],
    /// The nodes in the order in which they leave, the members in that in which they join, and those whose forces part behind nodes.
    pub(super) order: &'a [usize],
    pub(super) joining: &'a [u32],
    pub(super) parting: &'a [u32],
    /// The largest number of variables in a front.
    pub(super) width: usize,
}

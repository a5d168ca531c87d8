//! A network in numbers alone, as the stiffness pass reads it.

use crate::element::MemberNumbers;
use crate::model::MemberPlane;
use crate::number::Real;
use crate::pass::network::memory::Memory;
use crate::pass::network::motions::Motions;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::placement::Placement;
use crate::pass::network::stiffness::arrangement::arrange;
use crate::pass::network::stiffness::group::Group;
use crate::pass::network::stiffness::member::StiffnessMember;
use crate::pass::network::stiffness::node::StiffnessNode;
#[cfg(feature = "std")]
use crate::pass::network::stiffness::spatial_room::SpatialRoom;
use mstmm_plan::NetworkOrder;

/// Memory for a network in numbers, in the order in which a pass needs them.
#[derive(Clone, Debug)]
pub(crate) struct StiffnessRoom<M: Memory> {
    nodes: M::PerNode<StiffnessNode>,
    members: M::PerMember<StiffnessMember>,
    /// The parameters of members, from which a proof computes them anew.
    numbers: M::PerMember<MemberNumbers>,
    joining: M::PerMember<u32>,
    parting: M::PerMember<u32>,
    width: Option<usize>,
    /// Whether all nodes and members move in one plane.
    is_flat: bool,
    /// What nodes and members have in space.
    #[cfg(feature = "std")]
    space: SpatialRoom,
}

impl<M: Memory> StiffnessRoom<M> {
    /// Memory without a network, of so many nodes and members.
    pub(crate) fn new([nodes, members]: [usize; 2]) -> Self {
        StiffnessRoom {
            nodes: M::per_node(nodes, StiffnessNode::none()),
            members: M::per_member(members, StiffnessMember::none()),
            numbers: M::per_member(members, MemberNumbers::Other),
            joining: M::per_member(members, 0),
            parting: M::per_member(members, 0),
            width: None,
            is_flat: true,
            #[cfg(feature = "std")]
            space: SpatialRoom::default(),
        }
    }

    /// Keeps a node.
    pub(crate) fn set_node<T: Real>(&mut self, index: usize, node: &PlacedNode<T>, motions: &Motions<T>) {
        self.is_flat &= motions.is_in_plane();
        self.nodes.as_mut()[index] = StiffnessNode::new(node, motions);
    }

    /// Keeps a member in its place.
    pub(crate) fn set_member<T: Real>(&mut self, index: usize, numbers: MemberNumbers, placement: &Placement<T>) {
        self.is_flat &= placement.plane() == MemberPlane::Structure;
        self.members.as_mut()[index] = StiffnessMember::new(&numbers, placement);
        self.numbers.as_mut()[index] = numbers;
    }

    /// Keeps other parameters of a member.
    #[cfg(feature = "std")]
    pub(crate) fn set_numbers(&mut self, index: usize, numbers: MemberNumbers) {
        self.numbers.as_mut()[index] = numbers;
    }

    /// Arranges all that was kept for the passes to come.
    pub(crate) fn arrange(&mut self, order: &NetworkOrder<'_>) {
        let StiffnessRoom { nodes, members, joining, parting, width, is_flat, .. } = self;
        nodes.as_mut().iter_mut().for_each(|node| node.group = Group::NONE);
        let arranged = arrange(order, nodes.as_mut(), members.as_mut(), [joining.as_mut(), parting.as_mut()]);
        // without `std` there is no room for what a structure in space has besides
        *width = arranged.filter(|_| *is_flat || cfg!(feature = "std"));
    }

    /// Whether all nodes and members move in one plane.
    pub(crate) fn is_flat(&self) -> bool {
        self.is_flat
    }

    /// Keeps what nodes and parts of members have in space, if they move there.
    #[cfg(feature = "std")]
    pub(crate) fn set_space<T: Real>(
        &mut self,
        nodes: &[PlacedNode<T>],
        motions: &[Motions<T>],
        placements: &[Placement<T>],
    ) {
        if !self.is_flat {
            self.space = SpatialRoom::new(nodes, motions, placements);
        }
    }

    /// The members in numbers.
    pub(crate) fn numbers(&self) -> &[MemberNumbers] {
        self.numbers.as_ref()
    }

    /// The network, given its order, unless a member is not known in numbers, or too many displacements are in a front.
    pub(crate) fn model<'a>(&'a self, order: &NetworkOrder<'a>) -> Option<StiffnessModel<'a>> {
        let StiffnessRoom { nodes, members, joining, parting, width, .. } = self;
        (*width).map(|width| StiffnessModel {
            #[cfg(feature = "std")]
            space: (!self.is_flat).then_some(&self.space),
            nodes: nodes.as_ref(),
            members: members.as_ref(),
            order: order.nodes,
            joining: joining.as_ref(),
            parting: parting.as_ref(),
            width,
        })
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
    /// What nodes and members have in space; none in a plane structure.
    #[cfg(feature = "std")]
    pub(super) space: Option<&'a SpatialRoom>,
}

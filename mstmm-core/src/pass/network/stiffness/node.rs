//! A node of a network in numbers.

use crate::number::Real;
use crate::pass::network::motions::Motions;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::stiffness::group::Group;

/// The motions of a node and the inertia of its body.
#[derive(Clone, Copy, Debug)]
pub(super) struct StiffnessNode {
    pub(super) motions: usize,
    /// The lower triangle of the mass matrix over the motions, if there is a body.
    pub(super) masses: Option<[f64; 6]>,
    /// Its motions in the front.
    pub(super) group: Group,
    /// How many members have joined before it leaves, and how many rigid joints have parted behind it.
    pub(super) joined: u32,
    pub(super) parted: u32,
}

impl StiffnessNode {
    /// No node yet.
    pub(super) fn none() -> Self {
        StiffnessNode { motions: 0, masses: None, group: Group::NONE, joined: 0, parted: 0 }
    }

    /// A node that is not in the front yet.
    pub(super) fn new<T: Real>(node: &PlacedNode<T>, motions: &Motions<T>) -> Self {
        let masses = (node.has_body() && motions.is_in_plane()).then(|| {
            let rows = motions.masses::<T>(node).map(|row| row.map(T::to_f64));
            [rows[0][0], rows[1][0], rows[1][1], rows[2][0], rows[2][1], rows[2][2]]
        });
        StiffnessNode { motions: motions.count, masses, ..StiffnessNode::none() }
    }
}

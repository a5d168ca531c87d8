//! A network in numbers alone, as the stiffness pass reads it.

use crate::element::MemberNumbers;
use crate::number::Real;
use crate::pass::network::member::Placement;
use crate::pass::network::node::{Motions, Node};
use mstmm_plan::{Freedoms, NetworkOrder};

/// A member with what the freedoms of its ends are of the motions of its nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StiffnessMember {
    pub(super) numbers: MemberNumbers,
    /// Of each end, for displacements along and across the member: the parts of the motions of its node.
    pub(super) rows: [[[f64; 3]; 2]; 2],
    /// Whether the node of each end has no motions, and whether it turns, as its last motion.
    pub(super) rests: [bool; 2],
    pub(super) turns: [bool; 2],
    /// Of each end, the freedoms that it does not share with its node, and whether there are none.
    pub(super) released: [Freedoms; 2],
    pub(super) is_shared: bool,
}

impl StiffnessMember {
    /// No member yet.
    pub(crate) fn none() -> Self {
        StiffnessMember {
            numbers: MemberNumbers::Other,
            rows: [[[0.0; 3]; 2]; 2],
            rests: [true; 2],
            turns: [false; 2],
            released: [Freedoms::NONE; 2],
            is_shared: true,
        }
    }

    /// A member in its place. Of a joint that an end does not share in whole the stiffness is not known.
    pub(crate) fn new<T: Real>(numbers: MemberNumbers, placement: &Placement<T>) -> Self {
        let released = [0, 1].map(|end| placement.released(end));
        let is_shared = released == [Freedoms::NONE; 2];
        let is_known = is_shared || !matches!(numbers, MemberNumbers::Joint(..));
        StiffnessMember {
            numbers: if is_known { numbers } else { MemberNumbers::Other },
            rows: placement.rows().map(|[along, across, _]| [along, across].map(|row| row.map(T::to_f64))),
            rests: [0, 1].map(|end| placement.rests(end)),
            turns: placement.rows().map(|[.., rotation]| rotation.iter().any(|part| !part.vanishes())),
            released,
            is_shared,
        }
    }
}

/// The motions of a node and the inertia of its body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StiffnessNode {
    pub(super) motions: usize,
    /// The lower triangle of the mass matrix over the motions, if there is a body.
    pub(super) masses: Option<[f64; 6]>,
}

impl StiffnessNode {
    /// No node yet.
    pub(crate) fn none() -> Self {
        StiffnessNode { motions: 0, masses: None }
    }

    /// A node.
    pub(crate) fn new<T: Real>(node: &Node<T>, motions: &Motions<T>) -> Self {
        let masses = node.has_body().then(|| {
            let rows = motions.masses::<T>(node).map(|row| row.map(T::to_f64));
            [rows[0][0], rows[1][0], rows[1][1], rows[2][0], rows[2][1], rows[2][2]]
        });
        StiffnessNode { motions: motions.count, masses }
    }
}

/// A network in numbers.
#[derive(Clone, Copy, Debug)]
pub struct StiffnessModel<'a> {
    pub(crate) nodes: &'a [StiffnessNode],
    pub(crate) members: &'a [StiffnessMember],
    pub(crate) order: NetworkOrder<'a>,
}

impl StiffnessModel<'_> {
    /// Whether the stiffnesses of all members are known.
    pub(crate) fn is_known(&self) -> bool {
        self.members.iter().all(|member| member.numbers != MemberNumbers::Other)
    }
}

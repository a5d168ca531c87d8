//! A member in a front.

use crate::pass::network::stiffness::model::StiffnessMember;
use mstmm_plan::Freedoms;

/// The ends of a member in a front: where the motions of each node begin and how many they are, if it moves.
#[derive(Clone, Copy)]
pub(super) struct InFront<'a> {
    pub(super) ends: [Option<[usize; 2]>; 2],
    pub(super) member: &'a StiffnessMember,
}

impl InFront<'_> {
    /// Whether an end shares a freedom with its node.
    #[inline(always)]
    pub(super) fn has(&self, [end, freedom]: [usize; 2]) -> bool {
        !self.member.released[end].contains(Freedoms::SINGLE[freedom])
    }

    /// Where the rotation of an end stands: the last motion of its node, if that turns.
    #[inline(always)]
    pub(super) fn rotation(&self, end: usize) -> Option<usize> {
        let [first, count] = self.ends[end]?;
        self.member.turns[end].then(|| first + count - 1)
    }

    /// What a displacement of an end, along or across the member, or its rotation is of the motions of its node.
    #[inline(always)]
    pub(super) fn row(&self, end: usize, freedom: usize) -> [f64; 3] {
        if freedom < 2 {
            return self.member.rows[end][freedom];
        }
        let mut row = [0.0; 3];
        if let (true, Some([_, count])) = (self.member.turns[end], self.ends[end]) {
            row[count - 1] = 1.0;
        }
        row
    }
}

//! A member of a network in numbers.

use crate::element::MemberNumbers;
use crate::number::Real;
use crate::pass::network::placement::Placement;
use crate::pass::network::stiffness::group::Group;
use crate::pass::network::stiffness::numbers::Waving;
use mstmm_plan::Freedoms;

/// A member with what the freedoms of its ends are of the motions of its nodes.
#[derive(Clone, Copy, Debug)]
pub(super) struct StiffnessMember {
    pub(super) waving: Waving,
    /// Of each end, for displacements along and across the member: the parts of the motions of its node.
    pub(super) rows: [[[f64; 3]; 2]; 2],
    pub(super) seat: Seat,
}

/// How a member stands in the front.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seat {
    /// Whether the node of each end has no motions, and whether it turns, as its last motion.
    rests: [bool; 2],
    turns: [bool; 2],
    /// Of each end, the freedoms that it does not share with its node, and whether there are none.
    released: [Freedoms; 2],
    pub(super) is_shared: bool,
    /// Of each end, the motions of its node in the front.
    pub(super) nodes: [Group; 2],
    /// The forces of a rigid joint in the front.
    pub(super) ties: Group,
    /// In which place the waves of a beam are kept, and whether it is the one that fills it.
    pub(super) waves: u8,
    pub(super) is_first: bool,
}

impl Seat {
    /// No seat yet.
    const NONE: Seat = Seat {
        rests: [true; 2],
        turns: [false; 2],
        released: [Freedoms::NONE; 2],
        is_shared: true,
        nodes: [Group::NONE; 2],
        ties: Group::NONE,
        waves: 0,
        is_first: true,
    };

    /// Whether an end shares a freedom with its node.
    #[inline(always)]
    pub(super) fn has(&self, [end, freedom]: [usize; 2]) -> bool {
        !self.released[end].contains(Freedoms::SINGLE[freedom])
    }

    /// Where the motions of the node of an end begin in the front and how many they are, if it moves.
    #[inline(always)]
    pub(super) fn places(&self, end: usize) -> Option<[usize; 2]> {
        (!self.rests[end]).then(|| self.nodes[end].places())
    }

    /// Which motion of its node the rotation of an end is, if that turns: the last one.
    #[inline(always)]
    pub(super) fn rotation(&self, end: usize) -> Option<usize> {
        let [_, count] = self.places(end)?;
        self.turns[end].then(|| count - 1)
    }
}

impl StiffnessMember {
    /// No member yet.
    pub(super) fn none() -> Self {
        StiffnessMember { waving: Waving::Other, rows: [[[0.0; 3]; 2]; 2], seat: Seat::NONE }
    }

    /// A member in its place. Of a joint that an end does not share in whole the stiffness is not known.
    pub(super) fn new<T: Real>(numbers: &MemberNumbers, placement: &Placement<T>) -> Self {
        let released = [0, 1].map(|end| placement.released(end));
        let is_shared = released == [Freedoms::NONE; 2];
        let is_known = is_shared || !matches!(numbers, MemberNumbers::Joint(..));
        let seat = Seat {
            rests: [0, 1].map(|end| placement.rests(end)),
            turns: placement.rows().map(|[.., rotation]| rotation.iter().any(|part| !part.vanishes())),
            released,
            is_shared,
            ..Seat::NONE
        };
        StiffnessMember {
            waving: if is_known { Waving::new(numbers, placement.own_length().to_f64()) } else { Waving::Other },
            rows: placement
                .rows()
                .map(|[along, across, _]| [along, across].map(|[x, y, turn, ..]| [x, y, turn].map(T::to_f64))),
            seat,
        }
    }

    /// Number of forces by which a rigid joint ties its ends.
    pub(super) fn tie_count(&self) -> usize {
        match self.waving {
            Waving::Joint(rigid, _) => rigid.count(),
            _ => 0,
        }
    }

    /// What a displacement of an end, along or across the member, or its rotation is of the motions of its node.
    #[inline(always)]
    pub(super) fn row(&self, end: usize, freedom: usize) -> [f64; 3] {
        if freedom < 2 {
            return self.rows[end][freedom];
        }
        let mut row = [0.0; 3];
        if let Some(rotation) = self.seat.rotation(end) {
            row[rotation] = 1.0;
        }
        row
    }
}

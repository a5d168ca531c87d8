//! The order in which an evaluation goes through a network: computed once, in memory of a fixed size.

use crate::elimination::{Elimination, Incidence, apart, eliminated_in_order, in_motion};

/// A network as an evaluation goes through it.
#[derive(Clone, Copy, Debug)]
pub struct NetworkOrder<'a> {
    /// Which members each node has.
    pub incidence: Incidence<'a>,
    /// The nodes in the order of their elimination; those at rest leave with their members.
    pub nodes: &'a [usize],
    /// The place of each node in that order.
    ranks: &'a [usize],
}

impl NetworkOrder<'_> {
    /// Whether a member is cut by the elimination of the node of one of its ends, and this end stands for it.
    pub const fn is_first_at(&self, end: usize, node: usize) -> bool {
        let other = self.incidence.beyond(end);
        self.ranks[other] > self.ranks[node] || (other == node && end.is_multiple_of(2))
    }

    /// The largest number of unknowns at once, given the number of motions of each node and that of the freedoms of the ends of each member:
    /// the motions of nodes, and what members have of their own.
    pub const fn width(&self, motions: &[usize], freedoms: &[usize]) -> usize {
        let (mut unknowns, mut widest, mut rank) = (0, 0, 0);
        while rank < self.nodes.len() {
            let node = self.nodes[rank];
            let ends = self.incidence.ends(node);
            if !self.is_met_before(node, rank, 0, node) {
                unknowns += motions[node];
            }
            // a member has no more unknowns of its own than freedoms: with one more condition at an end its motion vanishes
            let (mut entering, mut place) = (0, 0);
            while place < ends.len() {
                let end = ends[place];
                if self.is_first_at(end, node) {
                    entering += freedoms[end / 2];
                    let other = self.incidence.beyond(end);
                    if other != node && !self.is_met_before(other, rank, place, node) {
                        unknowns += motions[other];
                    }
                }
                place += 1;
            }
            if unknowns + entering > widest {
                widest = unknowns + entering;
            }
            unknowns -= motions[node];
            rank += 1;
        }
        widest
    }

    /// Whether a member has met a node before: one of a node that has left before a rank, or one of the first so many ends of the node that
    /// leaves now.
    const fn is_met_before(&self, node: usize, rank: usize, ends_now: usize, now: usize) -> bool {
        let (ends, mut place) = (self.incidence.ends(node), 0);
        while place < ends.len() {
            if self.ranks[self.incidence.beyond(ends[place])] < rank {
                return true;
            }
            place += 1;
        }
        let (ends, mut place) = (self.incidence.ends(now), 0);
        while place < ends_now {
            if self.incidence.beyond(ends[place]) == node {
                return true;
            }
            place += 1;
        }
        false
    }
}

/// Memory of the caller's for the order of a network: a pair per member, and of the others an entry per node.
#[derive(Debug)]
pub struct OrderMemory<'a> {
    /// Ends.
    pub ends: &'a mut [[usize; 2]],
    /// Where the ends of each node begin.
    pub first_end: &'a mut [usize],
    /// The nodes in their order.
    pub nodes: &'a mut [usize],
    /// The place of each node in that order.
    pub ranks: &'a mut [usize],
    /// What the search keeps of each node, [`Elimination::UNKNOWN`] at first.
    pub elimination: &'a mut [Elimination],
}

impl<'a> OrderMemory<'a> {
    /// Puts a network in order, given the two nodes of each member. Nodes without members stand in none.
    pub const fn set_in_order(self, members: &'a [[usize; 2]]) -> NetworkOrder<'a> {
        let OrderMemory { ends, first_end, nodes, ranks, elimination } = self;
        let incidence = Incidence::new(members, first_end, ends.as_flattened_mut());
        let count = eliminated_in_order(&incidence, elimination, nodes);
        let mut rank = 0;
        while rank < count {
            let node = nodes[rank];
            ranks[node] = rank;
            rank += 1;
        }
        NetworkOrder { incidence, nodes: nodes.split_at(count).0, ranks }
    }
}

/// Memory for the order of a network of up to so many nodes and members.
#[derive(Clone, Copy, Debug)]
pub struct OrderRoom<const NODES: usize, const MEMBERS: usize> {
    members: [[usize; 2]; MEMBERS],
    first_end: [usize; NODES],
    ends: [[usize; 2]; MEMBERS],
    nodes: [usize; NODES],
    ranks: [usize; NODES],
    /// How many nodes there are in the order.
    in_order: usize,
}

impl<const NODES: usize, const MEMBERS: usize> OrderRoom<NODES, MEMBERS> {
    /// Memory without a network.
    pub const EMPTY: Self = OrderRoom {
        members: [[0; 2]; MEMBERS],
        first_end: [0; NODES],
        ends: [[0; 2]; MEMBERS],
        nodes: [0; NODES],
        ranks: [0; NODES],
        in_order: 0,
    };

    /// The order of a network that fills the memory, from the two nodes of each member.
    pub const fn of(members: [[usize; 2]; MEMBERS]) -> Self {
        let mut room = OrderRoom { members, ..Self::EMPTY };
        room.set_in_order(NODES, MEMBERS);
        room
    }

    /// Puts a network in order, given whether each node rests, their number, and the two nodes of each member. Returns a node that nothing
    /// joins to the others, if there is one.
    pub fn fill(
        &mut self,
        nodes: usize,
        rests: impl Fn(usize) -> bool,
        members: impl ExactSizeIterator<Item = [usize; 2]>,
    ) -> Option<usize> {
        let count = members.len();
        for (place, pair) in self.members.iter_mut().zip(members) {
            *place = pair;
        }
        let alone = apart(&self.members[..count], &mut self.ranks[..nodes]);
        for pair in &mut self.members[..count] {
            *pair = in_motion(*pair, pair.map(&rests));
        }
        self.set_in_order(nodes, count);
        alone
    }

    const fn set_in_order(&mut self, nodes: usize, members: usize) {
        let mut elimination = [Elimination::UNKNOWN; NODES];
        let OrderRoom { members: pairs, first_end, ends, nodes: order, ranks, in_order } = self;
        let memory = OrderMemory {
            ends: ends.as_mut_slice().split_at_mut(members).0,
            first_end: first_end.as_mut_slice().split_at_mut(nodes).0,
            nodes: order.as_mut_slice().split_at_mut(nodes).0,
            ranks: ranks.as_mut_slice().split_at_mut(nodes).0,
            elimination: elimination.split_at_mut(nodes).0,
        };
        *in_order = memory.set_in_order(pairs.as_slice().split_at(members).0).nodes.len();
    }

    /// The order of so many nodes and members.
    pub const fn order(&self, nodes: usize, members: usize) -> NetworkOrder<'_> {
        let OrderRoom { members: pairs, first_end, ends, nodes: order, ranks, in_order } = self;
        let ends = ends.as_slice().split_at(members).0.as_flattened();
        let pairs = pairs.as_slice().split_at(members).0;
        NetworkOrder {
            incidence: Incidence::sorted(pairs, first_end.as_slice().split_at(nodes).0, ends),
            nodes: order.as_slice().split_at(*in_order).0,
            ranks: ranks.as_slice().split_at(nodes).0,
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use std::vec::Vec;

    /// The members of a frame of storeys.
    fn storeys(bays: usize, levels: usize) -> Vec<[usize; 2]> {
        let at = |level: usize, column: usize| level * (bays + 1) + column;
        let columns = (1..=levels).flat_map(|level| (0..=bays).map(move |column| (level, column)));
        columns
            .flat_map(|(level, column)| {
                let girder = (column > 0).then(|| [at(level, column - 1), at(level, column)]);
                [Some([at(level - 1, column), at(level, column)]), girder]
            })
            .flatten()
            .collect()
    }

    /// Most unknowns at once with three freedoms everywhere.
    fn width(members: &[[usize; 2]]) -> usize {
        let nodes = 1 + members.iter().flatten().max().unwrap();
        let mut room = OrderRoom::<500, 900>::EMPTY;
        assert_eq!(room.fill(nodes, |_| false, members.iter().copied()), None);
        room.order(nodes, members.len()).width(&[3; 500], &[3; 900])
    }

    #[test]
    fn widths_do_not_grow_with_length() {
        for (bays, expected) in [(1, 15), (2, 18), (3, 21)] {
            assert_eq!([10, 40].map(|levels| width(&storeys(bays, levels))), [expected; 2]);
        }
        let chain = (0..400).map(|k| [k, k + 1]).collect::<Vec<_>>();
        let ring = (0..48).map(|k| [k, (k + 1) % 48]).collect::<Vec<_>>();
        // arms of five members
        let star = (0..40).map(|k| [if k % 5 == 0 { 0 } else { k }, k + 1]).collect::<Vec<_>>();
        assert_eq!([&chain, &ring, &star].map(|members| width(members)), [9, 15, 12]);
    }

    const CHAIN: OrderRoom<4, 3> = OrderRoom::of([[2, 0], [0, 3], [3, 1]]);

    #[test]
    fn a_constant_and_a_larger_room_have_one_order() {
        let mut room = OrderRoom::<7, 9>::EMPTY;
        assert_eq!(room.fill(4, |_| false, [[2, 0], [0, 3], [3, 1]].into_iter()), None);
        let (one, other) = (CHAIN.order(4, 3), room.order(4, 3));
        assert_eq!(one.nodes, other.nodes);
        assert_eq!(one.nodes, [1, 3, 0, 2]);
        // two nodes of three motions, and a member of as many freedoms
        assert_eq!(other.width(&[3; 4], &[3; 3]), 9);
    }

    #[test]
    fn a_node_that_nothing_joins_is_named() {
        let mut room = OrderRoom::<4, 2>::EMPTY;
        assert_eq!(room.fill(4, |_| false, [[0, 1], [2, 3]].into_iter()), Some(2));
    }
}

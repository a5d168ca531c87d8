//! The order in which an evaluation goes through a network: computed once, in memory of a fixed size.

use crate::elimination::{Elimination, Incidence, eliminated_in_order};

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

impl<'a> NetworkOrder<'a> {
    /// The order that [`OrderMemory::set_in_order`] has left in its memory: the two nodes of each member, where the ends of each node begin and
    /// these ends, the nodes in their order, and the place of each.
    pub const fn found(
        members: &'a [[usize; 2]],
        (first_end, ends): (&'a [usize], &'a [usize]),
        nodes: &'a [usize],
        ranks: &'a [usize],
    ) -> Self {
        NetworkOrder { incidence: Incidence::sorted(members, first_end, ends), nodes, ranks }
    }
}

impl NetworkOrder<'_> {
    /// Whether a member is cut by the elimination of the node of one of its ends, and this end stands for it.
    pub const fn is_first_at(&self, end: usize, node: usize) -> bool {
        let other = self.incidence.beyond(end);
        self.ranks[other] > self.ranks[node] || (other == node && end.is_multiple_of(2))
    }

    /// The largest number of unknowns at once, given the number of motions of each node and that of the freedoms of the ends of each member:
    /// the motions of nodes, what members have of their own, and what waits for a pivot.
    ///
    /// Unknowns without a pivot wait, such as the forces of two rigid joints that lead on from one node. If the matrix of all unknowns is regular, no more
    /// of those that nothing joins any more are without one than there are others to which they are coupled: the motions of the nodes that are met
    /// and have not left.
    pub const fn width(&self, motions: &[usize], freedoms: &[usize]) -> usize {
        let (mut met, mut waiting, mut widest, mut rank) = (0, 0, 0, 0);
        while rank < self.nodes.len() {
            let node = self.nodes[rank];
            let ends = self.incidence.ends(node);
            if !self.is_met_before(node, rank, 0, node) {
                met += motions[node];
            }
            let mut place = 0;
            while place < ends.len() {
                let end = ends[place];
                if self.is_first_at(end, node) {
                    let other = self.incidence.beyond(end);
                    if other != node && !self.is_met_before(other, rank, place, node) {
                        met += motions[other];
                    }
                    waiting = smaller(waiting, met);
                    // a member has no more unknowns of its own than freedoms: with one more condition at an end its motion vanishes
                    if met + waiting + freedoms[end / 2] > widest {
                        widest = met + waiting + freedoms[end / 2];
                    }
                    waiting += freedoms[end / 2];
                }
                place += 1;
            }
            met -= motions[node];
            waiting = smaller(waiting + motions[node], met);
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

/// The smaller one of two numbers.
const fn smaller(one: usize, other: usize) -> usize {
    if one < other { one } else { other }
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

/// The order of a network of so many nodes and members.
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
    /// The order, from the two nodes of each member.
    pub const fn of(members: [[usize; 2]; MEMBERS]) -> Self {
        let (mut first_end, mut ends) = ([0; NODES], [[0; 2]; MEMBERS]);
        let (mut nodes, mut ranks) = ([0; NODES], [0; NODES]);
        let memory = OrderMemory {
            ends: &mut ends,
            first_end: &mut first_end,
            nodes: &mut nodes,
            ranks: &mut ranks,
            elimination: &mut [Elimination::UNKNOWN; NODES],
        };
        let in_order = memory.set_in_order(&members).nodes.len();
        OrderRoom { members, first_end, ends, nodes, ranks, in_order }
    }

    /// The order.
    pub const fn order(&self) -> NetworkOrder<'_> {
        let OrderRoom { members, first_end, ends, nodes, ranks, in_order } = self;
        let ends = (first_end.as_slice(), ends.as_slice().as_flattened());
        NetworkOrder::found(members, ends, nodes.as_slice().split_at(*in_order).0, ranks)
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
        let (mut ends, mut elimination) = (std::vec![[0; 2]; members.len()], std::vec![Elimination::UNKNOWN; nodes]);
        let [mut first_end, mut in_order, mut ranks] = [(); 3].map(|()| std::vec![0; nodes]);
        let memory = OrderMemory {
            ends: &mut ends,
            first_end: &mut first_end,
            nodes: &mut in_order,
            ranks: &mut ranks,
            elimination: &mut elimination,
        };
        memory.set_in_order(members).width(&std::vec![3; nodes], &std::vec![3; members.len()])
    }

    #[test]
    fn widths_do_not_grow_with_length() {
        for (bays, expected) in [(1, 21), (2, 27), (3, 33)] {
            assert_eq!([10, 40].map(|levels| width(&storeys(bays, levels))), [expected; 2]);
        }
        let chain = (0..400).map(|k| [k, k + 1]).collect::<Vec<_>>();
        let ring = (0..48).map(|k| [k, (k + 1) % 48]).collect::<Vec<_>>();
        // arms of five members
        let star = (0..40).map(|k| [if k % 5 == 0 { 0 } else { k }, k + 1]).collect::<Vec<_>>();
        assert_eq!([&chain, &ring, &star].map(|members| width(members)), [12, 18, 18]);
    }

    const CHAIN: OrderRoom<4, 3> = OrderRoom::of([[2, 0], [0, 3], [3, 1]]);

    #[test]
    fn a_constant_has_an_order() {
        let order = CHAIN.order();
        assert_eq!(order.nodes, [1, 3, 0, 2]);
        // two nodes of three motions, a member of as many freedoms, and three forces that may wait
        assert_eq!(order.width(&[3; 4], &[3; 3]), 12);
    }
}

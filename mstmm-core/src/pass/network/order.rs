//! The order in which the nodes of a list leave, found once.

use crate::pass::network::memory::Memory;
use mstmm_plan::{Elimination, NetworkOrder, OrderMemory, apart, in_motion};

/// The order of a network in its memory.
#[derive(Clone, Debug)]
pub(super) struct Order<M: Memory> {
    /// The two nodes of each member, those in motion.
    pairs: M::PerMember<[usize; 2]>,
    ends: M::PerMember<[usize; 2]>,
    first_end: M::PerNode<usize>,
    nodes: M::PerNode<usize>,
    ranks: M::PerNode<usize>,
    sizes: [usize; 2],
    /// How many nodes there are in the order.
    in_order: usize,
}

impl<M: Memory> Order<M> {
    /// The order of a network of so many nodes and members, given the two nodes of each member, and whether a node rests.
    ///
    /// # Errors
    /// A node that nothing joins to the others.
    pub(super) fn of(
        sizes: [usize; 2],
        nodes_of: impl Fn(usize) -> [usize; 2],
        rests: impl Fn(usize) -> bool,
    ) -> Result<Self, usize> {
        let [node_count, member_count] = sizes;
        let mut order = Order::<M> {
            pairs: M::per_member(member_count, [0; 2]),
            ends: M::per_member(member_count, [0; 2]),
            first_end: M::per_node(node_count, 0),
            nodes: M::per_node(node_count, 0),
            ranks: M::per_node(node_count, 0),
            sizes,
            in_order: 0,
        };
        let mut elimination = M::per_node(node_count, Elimination::UNKNOWN);
        let pairs: &mut [_] = &mut order.pairs.as_mut()[..member_count];
        pairs.iter_mut().enumerate().for_each(|(member, pair)| *pair = nodes_of(member));
        if let Some(node) = apart(pairs, &mut order.ranks.as_mut()[..node_count]) {
            return Err(node);
        }
        pairs.iter_mut().for_each(|pair| *pair = in_motion(*pair, pair.map(&rests)));
        let memory = OrderMemory {
            ends: &mut order.ends.as_mut()[..member_count],
            first_end: &mut order.first_end.as_mut()[..node_count],
            nodes: &mut order.nodes.as_mut()[..node_count],
            ranks: &mut order.ranks.as_mut()[..node_count],
            elimination: &mut elimination.as_mut()[..node_count],
        };
        order.in_order = memory.set_in_order(pairs).nodes.len();
        Ok(order)
    }

    /// The order.
    pub(super) fn get(&self) -> NetworkOrder<'_> {
        let [nodes, members] = self.sizes;
        NetworkOrder::found(
            &self.pairs.as_ref()[..members],
            (&self.first_end.as_ref()[..nodes], self.ends.as_ref()[..members].as_flattened()),
            &self.nodes.as_ref()[..self.in_order],
            &self.ranks.as_ref()[..nodes],
        )
    }
}

//! The order in which the nodes of a network are eliminated: greedily by the smallest boundary, then one front upon the other.

/// No node.
const NONE: usize = usize::MAX;

/// What the search for an order keeps of each node.
#[derive(Clone, Copy, Debug)]
pub struct Elimination {
    /// The node in whose elimination the front of this one is taken up; none of the last one.
    parent: usize,
    /// Ends of cut members on the boundary of the front, once the node is eliminated.
    ends: usize,
    is_eliminated: bool,
    /// Members at the node that its elimination cuts, and those that are cut already.
    new: usize,
    taken: usize,
    /// The first node whose front this one takes up, and the next one that its parent does.
    first_child: usize,
    next_sibling: usize,
}

impl Elimination {
    /// A node about which nothing is known yet.
    pub const UNKNOWN: Elimination = Elimination {
        parent: NONE,
        ends: 0,
        is_eliminated: false,
        new: 0,
        taken: 0,
        first_child: NONE,
        next_sibling: NONE,
    };
}

/// The nodes of each member, and the members of each node.
#[derive(Clone, Copy, Debug)]
pub struct Incidence<'a> {
    members: &'a [[usize; 2]],
    /// Where the ends of each node begin among all.
    first_end: &'a [usize],
    /// The ends, node by node: the number of a member twice, and one more for its second end.
    ends: &'a [usize],
}

impl<'a> Incidence<'a> {
    /// Sorts the ends of members by their nodes, into memory for a number per node and for two per member.
    pub(crate) const fn new(members: &'a [[usize; 2]], first_end: &'a mut [usize], ends: &'a mut [usize]) -> Self {
        let mut node = 0;
        while node < first_end.len() {
            first_end[node] = 0;
            node += 1;
        }
        let mut end = 0;
        while end < 2 * members.len() {
            first_end[members[end / 2][end % 2]] += 1;
            end += 1;
        }
        let (mut node, mut sum) = (0, 0);
        while node < first_end.len() {
            sum += first_end[node];
            first_end[node] = sum;
            node += 1;
        }
        // from the last one on, so that ends of a node stand in the order of the members
        while end > 0 {
            end -= 1;
            let node = members[end / 2][end % 2];
            first_end[node] -= 1;
            ends[first_end[node]] = end;
        }
        Incidence { members, first_end, ends }
    }

    /// The incidence whose ends are sorted already, as [`new`](Self::new) has left them.
    pub(crate) const fn sorted(members: &'a [[usize; 2]], first_end: &'a [usize], ends: &'a [usize]) -> Self {
        Incidence { members, first_end, ends }
    }

    /// The ends at a node.
    #[inline]
    pub const fn ends(&self, node: usize) -> &'a [usize] {
        let from = self.first_end[node];
        let to = if node + 1 < self.first_end.len() { self.first_end[node + 1] } else { 2 * self.members.len() };
        self.ends.split_at(to).0.split_at(from).1
    }

    /// The node of an end.
    pub const fn node(&self, end: usize) -> usize {
        self.members[end / 2][end % 2]
    }

    /// The node at the other end of the member of an end.
    pub const fn beyond(&self, end: usize) -> usize {
        self.members[end / 2][1 - end % 2]
    }
}

/// The first node that has no part in hanging together with the first one, given memory for a number per node.
pub const fn apart(members: &[[usize; 2]], part_of: &mut [usize]) -> Option<usize> {
    let mut node = 0;
    while node < part_of.len() {
        part_of[node] = node;
        node += 1;
    }
    let mut member = 0;
    while member < members.len() {
        let [one, other] = [root(part_of, members[member][0]), root(part_of, members[member][1])];
        // the first of both stands for the part
        if one < other {
            part_of[other] = one;
        } else {
            part_of[one] = other;
        }
        member += 1;
    }
    let mut node = 0;
    while node < part_of.len() {
        if root(part_of, node) != 0 {
            return Some(node);
        }
        node += 1;
    }
    None
}

/// The node that stands for the part of another one; the way there is halved.
const fn root(part_of: &mut [usize], node: usize) -> usize {
    let mut node = node;
    while part_of[node] != node {
        part_of[node] = part_of[part_of[node]];
        node = part_of[node];
    }
    node
}

/// The nodes of a member, given whether each rests: an end at a node without motions counts among those at the other one, so that
/// such a node is not eliminated.
pub const fn in_motion([from, to]: [usize; 2], rest: [bool; 2]) -> [usize; 2] {
    match rest {
        [false, false] => [from, to],
        [true, false] => [to; 2],
        [_, true] => [from; 2],
    }
}

/// Orders the nodes of a network that have members for a memory that holds one front upon the other: when a node is eliminated, the fronts
/// that it takes up are the last ones.
///
/// Each node is chosen such that it cuts the fewest members, among equals with most that are cut already: a chain is followed from its end,
/// a building storey by storey, a star from the tips of its arms. Parts that hang together through nodes at rest alone follow each other.
/// Returns how many nodes there are in the order.
pub(crate) const fn eliminated_in_order(
    incidence: &Incidence<'_>,
    nodes: &mut [Elimination],
    order: &mut [usize],
) -> usize {
    let mut node = 0;
    while node < nodes.len() {
        nodes[node].new = beyond_itself(incidence, node);
        node += 1;
    }
    loop {
        let node = next_node(incidence, nodes);
        if node == NONE {
            break;
        }
        take_up(incidence, nodes, node);
    }
    let (mut count, mut node) = (0, 0);
    while node < nodes.len() {
        if nodes[node].is_eliminated && nodes[node].parent == NONE {
            count = upon_each_other(nodes, node, order, count);
        }
        node += 1;
    }
    count
}

/// The number of ends at a node whose members lead to another one.
const fn beyond_itself(incidence: &Incidence<'_>, node: usize) -> usize {
    let here = incidence.ends(node);
    let (mut count, mut k) = (0, 0);
    while k < here.len() {
        if incidence.beyond(here[k]) != node {
            count += 1;
        }
        k += 1;
    }
    count
}

/// The node with members that is not eliminated yet and cuts the fewest ones; of several the one at which most are cut already.
const fn next_node(incidence: &Incidence<'_>, nodes: &[Elimination]) -> usize {
    let (mut best, mut new, mut taken) = (NONE, usize::MAX, 0);
    let mut node = 0;
    while node < nodes.len() {
        let own = &nodes[node];
        if (own.new < new || (own.new == new && own.taken > taken))
            && !own.is_eliminated
            && !incidence.ends(node).is_empty()
        {
            (best, new, taken) = (node, own.new, own.taken);
        }
        node += 1;
    }
    best
}

/// The node that stands for the front of an eliminated one: the last one that was eliminated with it.
const fn front_of(nodes: &[Elimination], node: usize) -> usize {
    let mut front = node;
    while nodes[front].parent != NONE {
        front = nodes[front].parent;
    }
    front
}

/// The ends of cut members on the boundary of the front of a node.
const fn boundary(incidence: &Incidence<'_>, nodes: &[Elimination], node: usize) -> usize {
    let here = incidence.ends(node);
    let (mut added, mut k) = (0, 0);
    while k < here.len() {
        let other = incidence.beyond(here[k]);
        if nodes[other].is_eliminated && is_first(incidence, nodes, node, k) {
            added += nodes[front_of(nodes, other)].ends;
        }
        k += 1;
    }
    added + nodes[node].new - nodes[node].taken
}

/// Whether an end is the first one of a node that leads to its front.
const fn is_first(incidence: &Incidence<'_>, nodes: &[Elimination], node: usize, end: usize) -> bool {
    let here = incidence.ends(node);
    let front = front_of(nodes, incidence.beyond(here[end]));
    let mut k = 0;
    while k < end {
        let other = incidence.beyond(here[k]);
        if nodes[other].is_eliminated && front_of(nodes, other) == front {
            return false;
        }
        k += 1;
    }
    true
}

/// Lets a node take up the front of another one.
const fn give_to(nodes: &mut [Elimination], front: usize, node: usize) {
    nodes[front].parent = node;
    nodes[front].next_sibling = nodes[node].first_child;
    nodes[node].first_child = front;
}

/// Eliminates a node: the fronts next to it become its own.
const fn take_up(incidence: &Incidence<'_>, nodes: &mut [Elimination], node: usize) {
    let here = incidence.ends(node);
    nodes[node].ends = boundary(incidence, nodes, node);
    let mut k = 0;
    while k < here.len() {
        let other = incidence.beyond(here[k]);
        if nodes[other].is_eliminated {
            let front = front_of(nodes, other);
            if front != node {
                give_to(nodes, front, node);
            }
        } else if other != node {
            nodes[other].new -= 1;
            nodes[other].taken += 1;
        }
        k += 1;
    }
    nodes[node].is_eliminated = true;
}

/// Sorts the nodes below one of them, behind so many others, so that each stands behind those whose fronts it takes up, and these stand next
/// to it. Returns how many there are then.
const fn upon_each_other(nodes: &[Elimination], last: usize, order: &mut [usize], before: usize) -> usize {
    let (mut count, mut node) = (before, deepest(nodes, last));
    loop {
        order[count] = node;
        count += 1;
        if node == last {
            return count;
        }
        node = match nodes[node].next_sibling {
            NONE => nodes[node].parent,
            sibling => deepest(nodes, sibling),
        };
    }
}

/// The first node to be eliminated below one.
const fn deepest(nodes: &[Elimination], node: usize) -> usize {
    let mut node = node;
    while nodes[node].first_child != NONE {
        node = nodes[node].first_child;
    }
    node
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order<const NODES: usize>(members: &[[usize; 2]]) -> ([usize; NODES], usize) {
        let (mut order, mut first_end, mut ends) = ([0; NODES], [0; NODES], [0; 16]);
        let incidence = Incidence::new(members, &mut first_end, &mut ends);
        let count = eliminated_in_order(&incidence, &mut [Elimination::UNKNOWN; NODES], &mut order);
        (order, count)
    }

    #[test]
    fn a_chain_is_followed_from_one_end_to_the_other() {
        assert_eq!(order::<5>(&[[3, 1], [1, 4], [4, 0], [0, 2]]), ([2, 0, 4, 1, 3], 5));
    }

    #[test]
    fn a_ring_is_followed_around() {
        let (order, count) = order::<6>(&[[0, 1], [1, 2], [2, 3], [3, 4], [4, 5], [5, 0]]);
        assert_eq!(count, 6);
        for pair in order.windows(2) {
            let distance = pair[0].abs_diff(pair[1]);
            assert!(distance == 1 || distance == 5 || order[..2].contains(&pair[0]), "{order:?}");
        }
    }

    #[test]
    fn each_node_stands_behind_the_fronts_that_it_takes_up_and_these_are_the_last_ones() {
        // a comb of three teeth
        let members = [[0, 1], [1, 2], [0, 3], [1, 4], [2, 5]];
        assert_eq!(order::<6>(&members), ([4, 3, 0, 1, 2, 5], 6));
    }

    #[test]
    fn several_members_between_two_nodes_and_one_with_both_ends_at_a_node_hold_no_order_up() {
        assert_eq!(order::<3>(&[[0, 1], [1, 0], [1, 1], [1, 2]]), ([2, 1, 0], 3));
    }

    #[test]
    fn parts_that_nothing_joins_are_found() {
        assert_eq!(apart(&[[0, 1], [2, 3]], &mut [0; 4]), Some(2));
        assert_eq!(apart(&[[3, 1], [2, 3], [1, 0]], &mut [0; 4]), None);
        assert_eq!(apart(&[], &mut [0; 1]), None);
    }

    #[test]
    fn parts_that_hang_together_at_rest_alone_stand_in_one_order() {
        // node 2 is held, and both members end at it
        let members = [in_motion([0, 2], [false, true]), in_motion([2, 1], [true, false])];
        assert_eq!(members, [[0, 0], [1, 1]]);
        assert_eq!(order::<3>(&members), ([0, 1, 0], 2));
        assert_eq!(in_motion([4, 3], [true, true]), [4, 4]);
    }
}

//! Paths through a network, which the overall transfer equation follows: from tips along a tree of members to one root. The members that
//! are not in the tree are cut, and what is cut is an input at both of its nodes.

use crate::freedom::Freedoms;

/// A member of a network as paths know it.
#[derive(Clone, Copy, Debug)]
pub struct PathMember {
    /// The nodes of its input and its output.
    pub nodes: [usize; 2],
    /// The freedoms of each end.
    pub freedoms: Freedoms,
    /// How many freedoms both ends together do not share with their nodes.
    pub released: usize,
}

/// A node of a network as paths know it.
#[derive(Clone, Copy, Debug)]
pub struct PathNode {
    /// The displacements of its states; others are at rest.
    pub freedoms: Freedoms,
    /// Whether a support holds some of them.
    pub is_supported: bool,
    /// Its place in an order from the root on, in which each node stands behind the one to which its path leads.
    pub rank: usize,
    /// The end of the member by which its path goes on: the number of the member twice, and one more for its output. The root has none.
    leaving: Option<usize>,
    /// The first end that brings all displacements of the node.
    reference: Option<usize>,
}

/// The rank of a node that no path reaches yet.
const UNREACHED: usize = usize::MAX;

impl PathMember {
    /// No member, as further parts of one are.
    pub const NONE: Self = PathMember { nodes: [0; 2], freedoms: Freedoms::NONE, released: 0 };
}

impl PathNode {
    /// No node.
    pub const NONE: Self = PathNode::new(Freedoms::NONE, Freedoms::NONE, false);

    /// A node with some freedoms, of which supports hold those of a set, or the displacement across a direction.
    pub const fn new(freedoms: Freedoms, held: Freedoms, is_held_across: bool) -> Self {
        let is_supported = is_held_across || !held.intersection(freedoms).is_empty();
        PathNode { freedoms, is_supported, rank: UNREACHED, leaving: None, reference: None }
    }

    /// Whether a path leads from it already.
    const fn is_reached(&self) -> bool {
        self.rank != UNREACHED
    }

    /// The end of the member by which the path of the node goes on; none at the root.
    pub const fn leaving(&self) -> Option<usize> {
        self.leaving
    }

    /// Whether the path of the node goes on by an end.
    pub const fn leaves_by(&self, end: usize) -> bool {
        matches!(self.leaving, Some(leaving) if leaving == end)
    }

    /// Whether the node has its displacements from an end.
    pub const fn is_led_by(&self, end: usize) -> bool {
        matches!(self.reference, Some(reference) if reference == end)
    }

    /// Whether the node has its displacements from an end of a member, and not from a tip of its own.
    pub const fn is_led(&self) -> bool {
        self.reference.is_some()
    }

    /// Whether half of the entries of a state are unknown here: at a support, at the root, and where no member brings all displacements.
    pub const fn is_boundary(&self) -> bool {
        self.is_supported || self.leaving.is_none() || !self.is_led()
    }

    /// The freedoms whose forces are zero where a member goes on with fewer, in the axes of the member. A node that moves along one line
    /// shares that motion with a member that has any translation, one that turns about one axis with a member that has any rotation.
    pub const fn left_behind(&self, member: Freedoms) -> Freedoms {
        let displacements = self.not_shared(Freedoms::DISPLACEMENTS, member);
        displacements.union(self.not_shared(Freedoms::ROTATIONS, member)).without(member)
    }

    /// The freedoms of a set that the node has, but for one alone where a member has any of them.
    const fn not_shared(&self, all: Freedoms, member: Freedoms) -> Freedoms {
        let own = self.freedoms.intersection(all);
        if own.count() == 1 && !member.intersection(all).is_empty() { Freedoms::NONE } else { own }
    }
}

/// Leads a path from each node to the root.
///
/// The root is the last of the supported nodes with most freedoms; without supports it is the first of all nodes with most. The tree grows
/// from there, always by the widest member, the first of equals, so that it is one of largest width: where a spring closes a loop the
/// spring is cut.
pub const fn lead_paths(nodes: &mut [PathNode], members: &[PathMember]) {
    let mut node = root(nodes);
    let mut rank = 0;
    // a path leads from both nodes of each member before the first one
    let (mut first, widest) = (0, widest(members));
    loop {
        nodes[node].rank = rank;
        rank += 1;
        while first < members.len()
            && nodes[members[first].nodes[0]].is_reached()
            && nodes[members[first].nodes[1]].is_reached()
        {
            first += 1;
        }
        let Some(end) = widest_end(nodes, members, (first, widest)) else { break };
        node = members[end / 2].nodes[end % 2];
        nodes[node].leaving = Some(end);
    }
    let mut end = 0;
    while end < 2 * members.len() {
        let PathMember { nodes: pair, freedoms, .. } = members[end / 2];
        let node = &mut nodes[pair[end % 2]];
        let brings_all = !freedoms.is_empty() && freedoms.count() == node.freedoms.count();
        if brings_all && node.reference.is_none() && !node.leaves_by(end) {
            node.reference = Some(end);
        }
        end += 1;
    }
}

const fn root(nodes: &[PathNode]) -> usize {
    let (mut best, mut node) = (0, 1);
    while node < nodes.len() {
        let (this, other) = (nodes[node], nodes[best]);
        let is_as_wide = this.freedoms.count() >= other.freedoms.count();
        let is_wider = this.freedoms.count() > other.freedoms.count();
        let is_better = match [this.is_supported, other.is_supported] {
            [true, true] => is_as_wide,
            [false, false] => is_wider,
            [is_supported, _] => is_supported,
        };
        if is_better {
            best = node;
        }
        node += 1;
    }
    best
}

/// The largest number of freedoms of a member.
const fn widest(members: &[PathMember]) -> usize {
    let (mut widest, mut member) = (0, 0);
    while member < members.len() {
        let width = members[member].freedoms.count();
        if width > widest {
            widest = width;
        }
        member += 1;
    }
    widest
}

/// The end, at a node that is not reached yet, of the widest member that leads from there to one that is, of the members from one on; none is wider
/// than a given width.
const fn widest_end(nodes: &[PathNode], members: &[PathMember], (first, widest): (usize, usize)) -> Option<usize> {
    let (mut best, mut width, mut member) = (None, 0, first);
    while member < members.len() && width < widest {
        let [from, to] = members[member].nodes;
        let is_from_reached = nodes[from].is_reached();
        if is_from_reached != nodes[to].is_reached() && members[member].freedoms.count() > width {
            (best, width) = (Some(2 * member + is_from_reached as usize), members[member].freedoms.count());
        }
        member += 1;
    }
    best
}

/// Whether a member is cut.
pub const fn is_cut(nodes: &[PathNode], members: &[PathMember], member: usize) -> bool {
    let [from, to] = members[member].nodes;
    !nodes[from].leaves_by(2 * member) && !nodes[to].leaves_by(2 * member + 1)
}

/// Number of unknowns of the overall transfer equation: half of the entries of a state at each boundary, all of a member at its cut, and a
/// jump for each freedom that an end does not share.
pub const fn unknowns(nodes: &[PathNode], members: &[PathMember]) -> usize {
    let (mut sum, mut node) = (0, 0);
    while node < nodes.len() {
        if nodes[node].is_boundary() {
            sum += nodes[node].freedoms.count();
        }
        node += 1;
    }
    let mut member = 0;
    while member < members.len() {
        sum += members[member].released;
        if is_cut(nodes, members, member) {
            sum += members[member].freedoms.size();
        }
        member += 1;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREE: PathNode = PathNode::new(Freedoms::PLANE, Freedoms::NONE, false);
    const HELD: PathNode = PathNode::new(Freedoms::PLANE, Freedoms::PLANE, false);

    fn beam(nodes: [usize; 2]) -> PathMember {
        PathMember { nodes, freedoms: Freedoms::PLANE, released: 0 }
    }

    fn spring(nodes: [usize; 2]) -> PathMember {
        PathMember { nodes, freedoms: Freedoms::X, released: 0 }
    }

    /// The members that are cut, and the number of unknowns.
    fn led<const NODES: usize>(mut nodes: [PathNode; NODES], members: &[PathMember]) -> ([PathNode; NODES], usize) {
        lead_paths(&mut nodes, members);
        (nodes, unknowns(&nodes, members))
    }

    /// Three at each foot; no loop.
    #[test]
    fn a_portal_is_one_path_from_foot_to_foot() {
        let (nodes, unknowns) = led([HELD, FREE, FREE, HELD], &[beam([0, 1]), beam([1, 2]), beam([3, 2])]);
        assert_eq!(unknowns, 6);
        assert_eq!(nodes.map(|node| node.rank), [3, 2, 1, 0]);
        assert_eq!(nodes.map(|node| node.leaving), [Some(0), Some(2), Some(5), None]);
        assert_eq!(nodes.map(|node| node.reference), [None, Some(1), Some(3), Some(4)]);
    }

    /// Six at the cut, three displacements of the root.
    #[test]
    fn a_ring_is_cut_once_and_its_path_begins_there() {
        let members = [beam([0, 1]), beam([1, 2]), beam([2, 3]), beam([3, 0])];
        let (nodes, unknowns) = led([FREE; 4], &members);
        assert_eq!(unknowns, 9);
        let cut = [0, 1, 2, 3].map(|member| is_cut(&nodes, &members, member));
        assert_eq!(cut.into_iter().filter(|is_cut| *is_cut).count(), 1);
    }

    #[test]
    fn a_spring_that_closes_a_loop_is_cut_and_has_two_unknowns() {
        let members = [spring([0, 2]), beam([0, 1]), beam([1, 2]), beam([2, 3])];
        let (nodes, unknowns) = led([HELD, FREE, FREE, HELD], &members);
        assert_eq!(unknowns, 3 + 3 + 2);
        assert!(is_cut(&nodes, &members, 0));
    }

    /// A truss node has a tip of its own, since no bar of it brings both of its displacements.
    #[test]
    fn a_node_that_only_narrow_members_reach_has_a_tip() {
        let truss = PathNode::new(Freedoms::X.union(Freedoms::Y), Freedoms::RZ, false);
        let foot = PathNode { is_supported: true, ..truss };
        let (nodes, unknowns) = led([foot, truss, foot], &[spring([0, 1]), spring([1, 2])]);
        assert_eq!(unknowns, 6);
        assert!(nodes.iter().all(PathNode::is_boundary));
        assert_eq!(truss.left_behind(Freedoms::X), Freedoms::Y);
    }

    #[test]
    fn a_node_that_moves_along_a_line_leaves_no_force_across_it() {
        let point = PathNode::new(Freedoms::Bending, Freedoms::X, false);
        assert_eq!(point.left_behind(Freedoms::X), Freedoms::RZ);
        assert_eq!(point.left_behind(Freedoms::RZ), Freedoms::Y);
        assert_eq!(point.left_behind(Freedoms::Bending), Freedoms::NONE);
    }
}

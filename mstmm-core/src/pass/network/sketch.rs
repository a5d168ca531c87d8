//! What `system!` says of a network: its nodes and members by indices, its numbers by their place in a list.

use crate::model::Spot;
use mstmm_plan::{Freedoms, PathMember, PathNode, in_motion, lead_paths};

/// A network without its numbers.
///
/// These are a list: the two coordinates of each place, the two parts of each direction, mass, inertia and the two coordinates of the
/// centre of each body.
#[derive(Clone, Copy, Debug)]
pub struct NetworkSketch<const NODES: usize, const MEMBERS: usize> {
    /// The name of what stands at each place.
    pub places: &'static [&'static str],
    /// The name of what has each direction.
    pub directions: &'static [&'static str],
    /// The masses; several at one node are one body.
    pub bodies: &'static [SketchedBody],
    /// The nodes.
    pub nodes: [SketchedNode; NODES],
    /// The members.
    pub members: [SketchedMember; MEMBERS],
}

/// A mass at a node.
#[derive(Clone, Copy, Debug)]
pub struct SketchedBody {
    /// Its name.
    pub name: &'static str,
    /// Index of the node that it moves with.
    pub node: usize,
}

/// A node.
#[derive(Clone, Copy, Debug)]
pub struct SketchedNode {
    /// Index of its place; none of a motion of a path, which is along x.
    pub place: Option<usize>,
    /// The freedoms that it has.
    pub freedoms: Freedoms,
    /// The freedoms that are held, and those that it has not.
    pub held: Freedoms,
    /// Index of the direction along which it moves.
    pub along: Option<usize>,
}

/// A member.
#[derive(Clone, Copy, Debug)]
pub struct SketchedMember {
    /// Its name.
    pub name: &'static str,
    /// The freedoms of its ends.
    pub freedoms: Freedoms,
    /// Its input and its output.
    pub ends: [SketchedEnd; 2],
}

/// The end of a member.
#[derive(Clone, Copy, Debug)]
pub struct SketchedEnd {
    /// Index of its node.
    pub node: usize,
    /// Index of its place; none at a motion of a path.
    pub place: Option<usize>,
    /// Its x axis.
    pub axis: Axis,
}

/// The x axis of the end of a member.
#[derive(Clone, Copy, Debug)]
pub enum Axis {
    /// From the input end to the output end.
    Member,
    /// x of the plane.
    X,
    /// y of the plane.
    Y,
    /// The direction of an index.
    Along(usize),
    /// From the place of an index to that of another.
    FromTo(usize, usize),
}

impl<const NODES: usize, const MEMBERS: usize> NetworkSketch<NODES, MEMBERS> {
    /// The nodes of each member, those in motion.
    pub const fn pairs(&self) -> [[usize; 2]; MEMBERS] {
        let mut pairs = [[0; 2]; MEMBERS];
        let mut member = 0;
        while member < MEMBERS {
            let [from, to] = &self.members[member].ends;
            let rest = [self.nodes[from.node].rests(), self.nodes[to.node].rests()];
            pairs[member] = in_motion([from.node, to.node], rest);
            member += 1;
        }
        pairs
    }

    /// The paths of its overall transfer equation.
    pub const fn paths(&self) -> [PathNode; NODES] {
        let mut nodes = [PathNode::NONE; NODES];
        let mut node = 0;
        while node < NODES {
            let SketchedNode { freedoms, held, along, .. } = self.nodes[node];
            nodes[node] = PathNode::new(freedoms, held, along.is_some());
            node += 1;
        }
        let mut members = [PathMember::NONE; MEMBERS];
        let mut member = 0;
        while member < MEMBERS {
            let SketchedMember { freedoms, ends: [from, to], .. } = &self.members[member];
            members[member] = PathMember { nodes: [from.node, to.node], freedoms: *freedoms, released: 0 };
            member += 1;
        }
        lead_paths(&mut nodes, &members);
        nodes
    }

    /// What errors call a node: the name of its place, or its index where it is a motion of a path.
    pub fn spot(&self, node: usize) -> Spot {
        self.nodes[node].place.map_or(Spot::Node(node), |place| Spot::Named(self.places[place]))
    }
}

impl SketchedNode {
    /// Whether it has no motions.
    const fn rests(&self) -> bool {
        self.along.is_none() && self.held.contains(Freedoms::ALL)
    }
}

/// A model whose points have places.
pub trait Located {
    /// Room for its numbers.
    type Numbers: AsRef<[f64]>;

    /// The numbers of its sketch, then the parameters of its members.
    fn numbers(&self) -> Self::Numbers;
}

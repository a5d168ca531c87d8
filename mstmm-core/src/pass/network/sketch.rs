//! What `system!` says of a network: its nodes and members by indices, its numbers by their place in a list.

use crate::model::{Hold, PlanePoint, Spot, Tied};
use mstmm_plan::{Freedoms, OrderRoom, PathMember, PathNode, in_motion, lead_paths, unknowns};

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
    /// The points with a place; several at one node are tied rigidly.
    pub points: &'static [SketchedPoint],
    /// The supports of points.
    pub supports: &'static [SketchedSupport],
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

/// A point with a place.
#[derive(Clone, Copy, Debug)]
pub struct SketchedPoint {
    /// Its name.
    pub name: &'static str,
    /// Index of the node that it moves with.
    pub node: usize,
    /// Index of its place.
    pub place: usize,
    /// The freedoms that elements bring there.
    pub freedoms: Freedoms,
}

/// The support of a point.
#[derive(Clone, Copy, Debug)]
pub struct SketchedSupport {
    /// Its name.
    pub name: &'static str,
    /// Index of its point.
    pub point: usize,
    /// Index of the node that it holds: that of the point, or of a second support of a body one of its own.
    pub node: usize,
    /// The freedoms that it holds, besides the displacement across a direction.
    pub held: Freedoms,
    /// Index of the direction along which the point moves.
    pub along: Option<usize>,
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
    /// The name of its type, or its keyword where it has none; `tie` where a path acts on a point; none of a second support of a body.
    pub kind: Option<&'static str>,
    /// The freedoms of its ends.
    pub freedoms: Freedoms,
    /// The freedoms that its ends do not share with their nodes, in the axes of the member.
    pub released: Freedoms,
    /// Its input and its output.
    pub ends: [SketchedEnd; 2],
}

/// The end of a member.
#[derive(Clone, Copy, Debug)]
pub struct SketchedEnd {
    /// What it is joined to.
    pub seat: Seat,
    /// Its x axis.
    pub axis: Axis,
}

/// What the end of a member is joined to.
#[derive(Clone, Copy, Debug)]
pub enum Seat {
    /// The point of an index.
    Point(usize),
    /// The node of an index, where that is no point: the motion of a path, or the ground.
    Node(usize),
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
            let nodes = [self.node_of(from), self.node_of(to)];
            pairs[member] = in_motion(nodes, [self.nodes[nodes[0]].rests(), self.nodes[nodes[1]].rests()]);
            member += 1;
        }
        pairs
    }

    /// The largest number of unknowns at once, given the order of its nodes.
    pub const fn width(&self, order: &OrderRoom<NODES, MEMBERS>) -> usize {
        let (mut motions, mut freedoms) = ([0; NODES], [0; MEMBERS]);
        let mut node = 0;
        while node < NODES {
            motions[node] = self.nodes[node].motions();
            node += 1;
        }
        let mut member = 0;
        while member < MEMBERS {
            freedoms[member] = self.members[member].freedoms.count();
            member += 1;
        }
        order.order().width(&motions, &freedoms)
    }

    /// Number of unknowns of its overall transfer equation, given its paths.
    pub const fn unknowns(&self, paths: &[PathNode; NODES]) -> usize {
        unknowns(paths, &self.path_members())
    }

    /// The paths of its overall transfer equation.
    pub const fn paths(&self) -> [PathNode; NODES] {
        let mut nodes = [PathNode::NONE; NODES];
        let mut node = 0;
        while node < NODES {
            let SketchedNode { freedoms, held, along, .. } = self.nodes[node];
            nodes[node] = PathNode::new(freedoms.union(self.released_at(node)), held, along.is_some());
            node += 1;
        }
        lead_paths(&mut nodes, &self.path_members());
        nodes
    }

    /// The freedoms that ends of members have at a node and do not share with it: in states there they are, held where the node has them not.
    const fn released_at(&self, node: usize) -> Freedoms {
        let (mut released, mut member) = (Freedoms::NONE, 0);
        while member < MEMBERS {
            let SketchedMember { released: own, ends: [from, to], .. } = &self.members[member];
            if self.node_of(from) == node || self.node_of(to) == node {
                released = released.union(*own);
            }
            member += 1;
        }
        released
    }

    /// Its members as paths know them.
    const fn path_members(&self) -> [PathMember; MEMBERS] {
        let mut members = [PathMember::NONE; MEMBERS];
        let mut member = 0;
        while member < MEMBERS {
            let SketchedMember { freedoms, released, ends: [from, to], .. } = &self.members[member];
            let nodes = [self.node_of(from), self.node_of(to)];
            members[member] = PathMember { nodes, freedoms: *freedoms, released: 2 * released.count() };
            member += 1;
        }
        members
    }

    /// The node of the end of a member.
    pub(crate) const fn node_of(&self, end: &SketchedEnd) -> usize {
        match end.seat {
            Seat::Point(point) => self.points[point].node,
            Seat::Node(node) => node,
        }
    }

    /// The place of the end of a member; none at a motion of a path.
    pub(crate) fn place_of(&self, end: &SketchedEnd) -> Option<usize> {
        match end.seat {
            Seat::Point(point) => Some(self.points[point].place),
            Seat::Node(node) => self.nodes[node].place,
        }
    }

    /// The label of a point in a model.
    pub const fn label<M>(&self, point: usize) -> PlanePoint<M> {
        let SketchedPoint { node, place, freedoms, .. } = self.points[point];
        let mut hold = None;
        let mut support = 0;
        while support < self.supports.len() {
            let SketchedSupport { point: of, node, held, along, .. } = self.supports[support];
            if of == point {
                let across = if along.is_some() { Freedoms::X.union(Freedoms::Y) } else { Freedoms::NONE };
                hold = Some(Hold { node, freedoms: held.union(across) });
            }
            support += 1;
        }
        PlanePoint::tied(Tied { node, place: Some(place), freedoms, hold })
    }

    /// What errors call a node: the name of its place, or its index where it is a motion of a path.
    pub fn spot(&self, node: usize) -> Spot {
        self.nodes[node].place.map_or(Spot::Node(node), |place| Spot::Named(self.places[place]))
    }
}

impl SketchedNode {
    /// The motions that its supports leave.
    const fn motions(&self) -> usize {
        let free = Freedoms::PLANE.without(self.held);
        match self.along {
            Some(_) => 1 + free.intersection(Freedoms::RZ).count(),
            None => free.count(),
        }
    }

    /// Whether it has no motions.
    const fn rests(&self) -> bool {
        self.motions() == 0
    }
}

impl SketchedMember {
    /// The x axis of an end: what turns about z needs none but that of the plane.
    pub(crate) const fn axis(&self, end: usize) -> Axis {
        if self.freedoms.is(Freedoms::RZ) { Axis::X } else { self.ends[end].axis }
    }
}

/// A model whose points have places.
pub trait Located {
    /// Room for its numbers.
    type Numbers: AsRef<[f64]>;

    /// The numbers of its sketch, then the parameters of its members.
    fn numbers(&self) -> Self::Numbers;
}

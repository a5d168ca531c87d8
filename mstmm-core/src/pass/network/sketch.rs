//! What `system!` says of a network: its nodes and members by indices, its numbers by their place in a list.

use crate::model::{Hold, PlanePoint, SpacePoint, Spot, Tied};
use core::ops::Range;
use mstmm_plan::{Freedoms, OrderRoom, PathMember, PathNode, freedoms_of_part, in_motion, lead_paths, unknowns};

/// A network without its numbers.
///
/// These are a list: the coordinates of each place, the parts of each direction, and of each body its mass, its inertia and the coordinates of
/// its mass centre. A place has two coordinates in the plane and three in space, where an inertia has six entries.
#[derive(Clone, Copy, Debug)]
pub struct NetworkSketch<const NODES: usize, const MEMBERS: usize> {
    /// Whether its places have three coordinates.
    pub is_in_space: bool,
    /// The name of what stands at each place.
    pub places: &'static [&'static str],
    /// The directions.
    pub directions: &'static [SketchedDirection],
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

/// A direction.
#[derive(Clone, Copy, Debug)]
pub struct SketchedDirection {
    /// The name of what has it.
    pub name: &'static str,
    /// The word in front of it: `along`, `up`.
    pub word: &'static str,
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
    /// The freedoms that it holds, besides displacements across a direction, or along it.
    pub held: Freedoms,
    /// How the point moves where it does not along axes.
    pub skew: Option<SketchedSkew>,
}

/// How a point moves where it does not along axes: by the index of a direction.
#[derive(Clone, Copy, Debug)]
pub enum SketchedSkew {
    /// Along it.
    Along(usize),
    /// Across it.
    Normal(usize),
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
    /// How it moves where it does not along axes.
    pub skew: Option<SketchedSkew>,
}

/// A member, or a part of a member in space.
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
    /// The plane in which it moves.
    pub plane: SketchedPlane,
    /// Whether it is a further part of the member before it.
    pub is_further: bool,
    /// Its input and its output.
    pub ends: [SketchedEnd; 2],
}

/// The plane in which a member moves, or a part of one.
#[derive(Clone, Copy, Debug)]
pub enum SketchedPlane {
    /// x and y of the structure.
    Structure,
    /// x and y of the member.
    First(SketchedUp),
    /// x and z of the member.
    Second(SketchedUp),
    /// None: it has one motion, along an x axis or about it.
    OneMotion,
    /// None: it twists about x of the member.
    Twist,
}

/// The vector that is made the z axis of a member in space.
#[derive(Clone, Copy, Debug)]
pub enum SketchedUp {
    /// The direction of an index.
    Named(usize),
    /// z of space.
    Z,
    /// z of space, but x where the member leads along z: its planes are alike.
    Any,
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
    /// x of the structure; of what turns on a path in space z, about which its node turns.
    X,
    /// y of the structure.
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
            pairs[member] = in_motion(nodes, [self.motions_of(nodes[0]) == 0, self.motions_of(nodes[1]) == 0]);
            member += 1;
        }
        pairs
    }

    /// The largest number of unknowns at once, given the order of its nodes.
    pub const fn width(&self, order: &OrderRoom<NODES, MEMBERS>) -> usize {
        let (mut motions, mut freedoms) = ([0; NODES], [0; MEMBERS]);
        let mut node = 0;
        while node < NODES {
            motions[node] = self.motions_of(node);
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
        let (mut node, released) = (0, self.released());
        while node < NODES {
            let SketchedNode { freedoms, held, skew, .. } = self.nodes[node];
            nodes[node] = PathNode::new(freedoms.union(released[node]), held, skew.is_some());
            node += 1;
        }
        lead_paths(&mut nodes, &self.path_members());
        nodes
    }

    /// The freedoms that ends of members have at each node and do not share with it: in states there they are, held where the node has them not. In
    /// space axes of members are not those of nodes: one displacement brings all, and one rotation.
    const fn released(&self) -> [Freedoms; NODES] {
        let (mut released, mut member) = ([Freedoms::NONE; NODES], 0);
        while member < MEMBERS {
            let own = &self.members[member];
            if !own.released.is_empty() {
                let freedoms = freedoms_of_part(own.part(), own.released);
                let freedoms = if self.is_in_space { freedoms.in_any_axes() } else { freedoms };
                let [from, to] = [self.node_of(&own.ends[0]), self.node_of(&own.ends[1])];
                released[from] = released[from].union(freedoms);
                released[to] = released[to].union(freedoms);
            }
            member += 1;
        }
        released
    }

    /// Its members as paths know them.
    const fn path_members(&self) -> [PathMember; MEMBERS] {
        let mut members = [PathMember::NONE; MEMBERS];
        let (mut member, mut first) = (0, 0);
        while member < MEMBERS {
            let own = &self.members[member];
            if !own.is_further {
                first = member;
                members[first].nodes = [self.node_of(&own.ends[0]), self.node_of(&own.ends[1])];
            }
            members[first].freedoms = members[first].freedoms.union(freedoms_of_part(own.part(), own.freedoms));
            members[first].released += 2 * own.released.count();
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

    /// The label of a point in a model of the plane or of a line.
    pub const fn label<M>(&self, point: usize) -> PlanePoint<M> {
        PlanePoint::tied(self.tied(point, Freedoms::X.union(Freedoms::Y)))
    }

    /// The label of a point in a model in space.
    pub const fn label_in_space<M>(&self, point: usize) -> SpacePoint<M> {
        SpacePoint::tied(self.tied(point, Freedoms::X.union(Freedoms::Y).union(Freedoms::Z)))
    }

    /// Where a mass of a path is: it has the one motion of its node.
    pub const fn of_path(&self, node: usize) -> Tied {
        Tied { node, place: None, freedoms: self.nodes[node].freedoms, hold: None }
    }

    /// Where a point is, given the displacements of points.
    const fn tied(&self, point: usize, displacements: Freedoms) -> Tied {
        let SketchedPoint { node, place, freedoms, .. } = self.points[point];
        let mut hold = None;
        let mut support = 0;
        while support < self.supports.len() {
            let SketchedSupport { point: of, node, held, skew, .. } = self.supports[support];
            if of == point {
                let across = if skew.is_some() { displacements } else { Freedoms::NONE };
                hold = Some(Hold { node, freedoms: held.union(across) });
            }
            support += 1;
        }
        Tied { node, place: Some(place), freedoms, hold }
    }

    /// The parts of the member that begins with one of an index; none where it is a further part itself.
    pub fn parts(&self, first: usize) -> Range<usize> {
        if self.members.get(first).is_none_or(|member| member.is_further) {
            return first..first;
        }
        let further = self.members.iter().skip(first + 1).take_while(|member| member.is_further);
        first..first + 1 + further.count()
    }

    /// The freedoms that are held at a node, and those that it has not.
    pub(crate) const fn held(&self, node: usize) -> Freedoms {
        let beyond = if self.is_in_space { Freedoms::NONE } else { Freedoms::SPACE.without(Freedoms::PLANE) };
        self.nodes[node].held.union(beyond)
    }

    /// The number of motions that its supports leave a node.
    const fn motions_of(&self, node: usize) -> usize {
        let displacements = Freedoms::X.union(Freedoms::Y).union(Freedoms::Z);
        let free = Freedoms::SPACE.without(self.held(node));
        match self.nodes[node].skew {
            None => free.count(),
            Some(SketchedSkew::Along(_)) => 1 + free.without(displacements).count(),
            Some(SketchedSkew::Normal(_)) if self.is_in_space => 2 + free.without(displacements).count(),
            Some(SketchedSkew::Normal(_)) => 1 + free.without(displacements).count(),
        }
    }

    /// The x axis of an end: what turns about z of the plane needs none but that of the plane.
    pub(crate) const fn axis(&self, member: &SketchedMember, end: usize) -> Axis {
        let turns_in_plane = !self.is_in_space && member.freedoms.is(Freedoms::RZ);
        if turns_in_plane { Axis::X } else { member.ends[end].axis }
    }

    /// What errors call a node: the name of its place, or its index where it is a motion of a path.
    pub fn spot(&self, node: usize) -> Spot {
        self.nodes[node].place.map_or(Spot::Node(node), |place| Spot::Named(self.places[place]))
    }
}

impl SketchedMember {
    /// Which part of its member it is.
    const fn part(&self) -> usize {
        match self.plane {
            SketchedPlane::Structure | SketchedPlane::First(_) => 0,
            SketchedPlane::Second(_) => 1,
            SketchedPlane::OneMotion if self.freedoms.is(Freedoms::X) => 0,
            SketchedPlane::OneMotion | SketchedPlane::Twist => 2,
        }
    }
}

impl SketchedSkew {
    /// The index of its direction.
    pub(crate) const fn direction(self) -> usize {
        match self {
            SketchedSkew::Along(direction) | SketchedSkew::Normal(direction) => direction,
        }
    }
}

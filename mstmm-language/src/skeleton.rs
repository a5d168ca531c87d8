//! The skeleton of a network: nodes that move, members between them, masses at them, by indices, as the core evaluates them.
//!
//! Points that a rigid body ties are one node. A path of one motion has nodes of its own, which move along x, where it does not
//! act on a point at once.

mod assemble;
mod names;
mod order;
mod overall;
mod paths;
#[cfg(test)]
mod tests;
mod text;

use crate::ast::{Connection, Element};
use crate::keywords::Dimension;
use crate::network::FreedomSet;
use mstmm_plan::{Freedoms, freedoms_of_part};
use syn::Expr;

/// A network as nodes and members.
pub(crate) struct Skeleton<'a> {
    pub(crate) dimension: Dimension,
    pub(crate) places: Vec<Place>,
    pub(crate) directions: Vec<Direction>,
    pub(crate) bodies: Vec<Body<'a>>,
    pub(crate) nodes: Vec<Node<'a>>,
    pub(crate) members: Vec<Member<'a>>,
    /// The points with a place, as the network has them.
    pub(crate) points: Vec<Point<'a>>,
    pub(crate) supports: Vec<Support>,
}

/// A point with a place.
pub(crate) struct Point<'a> {
    pub(crate) name: String,
    /// The connections that it has the labels of.
    pub(crate) connections: &'a [&'a Connection],
    /// Indices of its node and of its place.
    pub(crate) node: usize,
    pub(crate) place: usize,
    /// The freedoms that elements bring there.
    pub(crate) freedoms: FreedomSet<'a>,
}

/// The support of a point.
pub(crate) struct Support {
    pub(crate) name: String,
    /// Index of its point.
    pub(crate) point: usize,
    /// Index of the node that it holds.
    pub(crate) node: usize,
    /// What it holds of the freedoms of its point, besides displacements across a direction, or along it.
    pub(crate) held: Freedoms,
    /// How the point moves where it does not along axes.
    pub(crate) skew: Option<Skew>,
}

/// How a point moves where it does not along axes.
#[derive(Clone, Copy)]
pub(crate) struct Skew {
    /// Index of the direction.
    pub(crate) direction: usize,
    /// Whether it is held along that, and moves across it.
    pub(crate) is_normal: bool,
}

/// A place, with the name of what stands there.
pub(crate) struct Place {
    pub(crate) name: String,
    /// One part or several; the others are zero.
    pub(crate) parts: Vec<Expr>,
}

/// A direction, with the name of what has it and the word in front of it.
pub(crate) struct Direction {
    pub(crate) name: String,
    pub(crate) word: String,
    /// One part or several; the others are zero.
    pub(crate) parts: Vec<Expr>,
}

/// A mass at a node.
pub(crate) struct Body<'a> {
    pub(crate) element: &'a Element,
    pub(crate) node: usize,
    /// The coordinates of its mass centre; none on a path, where it does not matter.
    pub(crate) centre: Vec<Expr>,
}

/// A node.
pub(crate) struct Node<'a> {
    pub(crate) name: String,
    /// Index of its place; none on a path.
    pub(crate) place: Option<usize>,
    /// The freedoms that it has.
    pub(crate) freedoms: FreedomSet<'a>,
    /// The freedoms that are held, besides those that it has not.
    pub(crate) held: Freedoms,
    /// How it moves where it does not along axes.
    pub(crate) skew: Option<Skew>,
    /// The freedoms that nodes may have.
    pub(crate) all: Freedoms,
}

/// A member, or a part of a member in space.
pub(crate) struct Member<'a> {
    pub(crate) what: What<'a>,
    pub(crate) name: String,
    /// The name of its type, or its keyword where it has none; none of a second support of a body.
    pub(crate) kind: Option<String>,
    pub(crate) freedoms: FreedomSet<'a>,
    pub(crate) plane: Plane,
    /// Whether it is a further part of the member before it.
    pub(crate) is_further: bool,
    pub(crate) ends: [End; 2],
}

/// The plane in which a member moves, or a part of one.
#[derive(Clone, Copy)]
pub(crate) enum Plane {
    /// x and y of the structure.
    Structure,
    /// x and y of the member.
    First(Up),
    /// x and z of the member.
    Second(Up),
    /// None: it has one motion.
    OneMotion,
    /// None: it twists about x of the member.
    Twist,
}

/// The vector that is made the z axis of a member.
#[derive(Clone, Copy)]
pub(crate) enum Up {
    /// The direction of an index.
    Named(usize),
    /// z of space.
    Z,
    /// z of space, but x where the member leads along z: its planes are alike.
    Any,
}

impl Member<'_> {
    /// The freedoms that its ends do not share with their nodes.
    pub(crate) fn released(&self) -> Freedoms {
        let row = self.what.element().and_then(|element| element.located());
        row.map_or(Freedoms::NONE, |row| row.released)
    }
}

impl Member<'_> {
    /// Which part of its member it is, if the macro knows that.
    pub(crate) fn part(&self) -> Option<usize> {
        match self.plane {
            Plane::Structure | Plane::First(_) => Some(0),
            Plane::Second(_) => Some(1),
            Plane::OneMotion if self.freedoms.as_known()?.is(Freedoms::X) => Some(0),
            Plane::OneMotion | Plane::Twist => Some(2),
        }
    }

    /// The freedoms of its member that its ends do not share with their nodes.
    fn released_of_member(&self) -> Freedoms {
        self.part().map_or(Freedoms::NONE, |part| freedoms_of_part(part, self.released()))
    }
}

/// What stands between two ends.
#[derive(Clone, Copy)]
pub(crate) enum What<'a> {
    /// An element of the model.
    Element(&'a Element),
    /// A hinge of the model, which is a joint with springs.
    Hinge(&'a Element),
    /// A rigid joint of the freedoms of the member.
    Rigid,
}

/// The end of a member.
#[derive(Clone, Copy)]
pub(crate) struct End {
    pub(crate) seat: Seat,
    pub(crate) axis: Axis,
}

/// What the end of a member is joined to.
#[derive(Clone, Copy)]
pub(crate) enum Seat {
    /// The point of an index.
    Point(usize),
    /// The node of an index, which is no point: a motion of a path, or the ground.
    Node(usize),
}

/// The x axis of the end of a member.
#[derive(Clone, Copy)]
pub(crate) enum Axis {
    /// From the input to the output.
    Member,
    X,
    Y,
    /// The direction of an index.
    Along(usize),
    /// From the place of an index to that of another.
    FromTo([usize; 2]),
}

impl<'a> What<'a> {
    /// The element of the model that has its parameters.
    pub(crate) fn element(self) -> Option<&'a Element> {
        match self {
            What::Element(element) | What::Hinge(element) => Some(element),
            What::Rigid => None,
        }
    }
}

impl Skeleton<'_> {
    /// Whether rustc alone knows the freedoms of some members, which are the user's own.
    pub(crate) fn has_own_motions(&self) -> bool {
        self.members.iter().any(|member| member.freedoms.as_known().is_none())
    }

    /// The nodes at both ends of a member.
    fn nodes_of(&self, member: &Member<'_>) -> [usize; 2] {
        member.ends.map(|end| match end.seat {
            Seat::Point(point) => self.points[point].node,
            Seat::Node(node) => node,
        })
    }
}

impl Node<'_> {
    /// The freedoms that it has, and those that are held or that it has not, if rustc need not be asked.
    pub(crate) fn known(&self) -> Option<[Freedoms; 2]> {
        let freedoms = self.freedoms.as_known()?;
        let held = self.held.union(self.all.without(freedoms));
        Some([freedoms, if self.skew.is_some() { held.intersection(Freedoms::ROTATIONS) } else { held }])
    }

    /// The motions that its supports leave, as far as they are known.
    pub(crate) fn motions(&self) -> usize {
        let free = self.all.without(self.known().map_or(self.held, |[_, held]| held));
        let rotations = free.intersection(Freedoms::ROTATIONS).count();
        match self.skew {
            Some(Skew { is_normal: true, .. }) => {
                self.all.intersection(Freedoms::DISPLACEMENTS).count() - 1 + rotations
            }
            Some(_) => 1 + rotations,
            None => free.count(),
        }
    }
}

//! The types of a network: what `check` hands over to the emission.

use super::freedoms::FreedomSet;
use super::paths::PathMotion;
use crate::ast::{self, Connection, Coordinates, Element};
use crate::diagnostics::Place;
use crate::keywords::Dimension;
use mstmm_plan::{Freedoms, Space};
use syn::Expr;

/// A checked network. Its lists are in source order, and its indices lead into them.
pub(crate) struct Network<'a> {
    pub(crate) dimension: Dimension,
    /// The `at` of each place, with as many parts as the dimension has.
    pub(crate) places: Vec<&'a Coordinates>,
    /// Connections, supports and masses first, then the points that are an arrow between two elements.
    pub(crate) points: Vec<Point<'a>>,
    pub(crate) supports: Vec<Support<'a>>,
    pub(crate) members: Vec<Member<'a>>,
    pub(crate) joints: Vec<Joint<'a>>,
    pub(crate) bodies: Vec<RigidBody<'a>>,
    pub(crate) masses: Vec<PointMass<'a>>,
    pub(crate) paths: Vec<TransferPath<'a>>,
    pub(crate) suspicions: Vec<Suspicion<'a>>,
}

/// What is wrong if elements of the user's own move as they may: rustc alone knows whether they do.
pub(crate) struct Suspicion<'a> {
    /// The tokens that the message is at.
    pub(crate) place: Place,
    pub(crate) message: String,
    /// The elements, each with the space of states that all of them have if it is wrong.
    pub(crate) of: Vec<(&'a Element, Space)>,
}

/// A point with a place.
pub(crate) struct Point<'a> {
    /// Index into [`Network::places`]: points on both sides of a joint have one place.
    pub(crate) place: usize,
    /// The connections of this point: none where an arrow leads from element to element, or from a support to one.
    pub(crate) connections: Vec<&'a Connection>,
    /// The freedoms that its neighbours bring.
    pub(crate) freedoms: FreedomSet<'a>,
}

/// A support of a point.
pub(crate) struct Support<'a> {
    pub(crate) support: &'a ast::Support,
    pub(crate) point: usize,
    pub(crate) holds: Holds<'a>,
}

/// What a support holds of the freedoms that its point has.
pub(crate) enum Holds<'a> {
    /// Freedoms of the axes.
    Freedoms(Freedoms),
    /// A displacement by the word of the direction, `along` which the point moves or `normal` to which it does, and these other freedoms.
    Skew(&'a Coordinates, Freedoms),
}

/// An element with extent.
pub(crate) struct Member<'a> {
    pub(crate) element: &'a Element,
    /// The points at its input and at its output; local x leads from the first to the second.
    pub(crate) ends: [usize; 2],
}

/// An element between two points at one place.
pub(crate) struct Joint<'a> {
    pub(crate) element: &'a Element,
    /// The points at its input and at its output.
    pub(crate) ends: [usize; 2],
    /// The direction of its x axis; empty where it has the axes of the structure.
    pub(crate) axis: Vec<Expr>,
}

/// A mass with extent, which ties points rigidly.
pub(crate) struct RigidBody<'a> {
    /// The mention with the parameters.
    pub(crate) element: &'a Element,
    /// The coordinates of its mass centre.
    pub(crate) centre: Vec<Expr>,
    pub(crate) points: Vec<usize>,
}

/// A mass at a point.
pub(crate) struct PointMass<'a> {
    pub(crate) element: &'a Element,
    pub(crate) point: usize,
}

/// A path of translation or of rotation.
pub(crate) struct TransferPath<'a> {
    pub(crate) motion: PathMotion<'a>,
    /// The motions of the path: one at each end of each element, shared where elements meet.
    pub(crate) nodes: Vec<PathNode<'a>>,
    pub(crate) elements: Vec<PathElement<'a>>,
    pub(crate) contacts: Vec<PathContact<'a>>,
}

/// A motion of a path.
pub(crate) struct PathNode<'a> {
    /// Its connections, which have no place.
    pub(crate) connections: Vec<&'a Connection>,
    /// Whether `fixed` holds it; of a free end, or without a support, it does not.
    pub(crate) is_held: bool,
}

/// An element of a path.
pub(crate) struct PathElement<'a> {
    pub(crate) element: &'a Element,
    /// The motions at its input and at its output: indices into [`TransferPath::nodes`].
    pub(crate) ends: [usize; 2],
}

/// Where a path acts on a point: its motion there is that of the point in a direction.
pub(crate) struct PathContact<'a> {
    /// Index into [`TransferPath::nodes`].
    pub(crate) node: usize,
    /// Index into [`Network::points`].
    pub(crate) point: usize,
    pub(crate) direction: Direction<'a>,
}

/// The direction of a path at a contact.
pub(crate) enum Direction<'a> {
    /// Two parts of any length, `along (dx, dy)`.
    Along(&'a Coordinates),
    /// From the place of one point to that of another: of a path between two points, from the first contact to the second.
    FromTo([usize; 2]),
    /// Across a line of one coordinate.
    Y,
    /// About the axis of rotation, which is all that a motion has that no direction is said of.
    Z,
}

//! The nodes of plane lists: points with what holds them and rigid bodies about them.

use crate::model::Skew;
use crate::number::Parameter;
use crate::pass::network::placed_node::PlacedNode;
use mstmm_plan::Freedoms;

/// A point of a plane network, with the displacements x, y and the rotation about z.
///
/// ```
/// use mstmm_core::{Node, Support};
/// let foot = Node::at([0.0, 0.0]).held(Support::Pinned.holds());
/// let machine = Node::at([2.0, 3.0]).with_body(150.0, 12.0, [2.0, 3.4]);
/// assert!(foot.mass == 0.0 && machine.inertia == 12.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node<T> {
    /// Its place \[m\].
    pub position: [T; 2],
    /// The freedoms that are held.
    pub held: Freedoms,
    /// The direction along which the node moves, of any length; it is held across. None where x and y are as `held` says.
    pub along: Option<[T; 2]>,
    /// Mass of a rigid body that moves with the node \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia of the body about its mass centre [kg m²], zero or positive.
    pub inertia: T,
    /// Mass centre of the body \[m\].
    pub centre: [T; 2],
}

impl<T: Parameter> Node<T> {
    /// A free point without mass.
    pub fn at(position: [T; 2]) -> Self {
        Node { position, held: Freedoms::NONE, along: None, mass: T::zero(), inertia: T::zero(), centre: position }
    }

    /// The point with freedoms held, such as `Support::Fixed.holds()`.
    #[must_use]
    pub fn held(self, held: Freedoms) -> Self {
        Node { held, ..self }
    }

    /// The point held across a direction, along which it moves.
    #[must_use]
    pub fn along(self, direction: [T; 2]) -> Self {
        Node { along: Some(direction), ..self }
    }

    /// The point with a rigid body: its mass, its moment of inertia about its mass centre, and that centre.
    #[must_use]
    pub fn with_body(self, mass: T, inertia: T, centre: [T; 2]) -> Self {
        Node { mass, inertia, centre, ..self }
    }
}

/// A place of the plane in space.
pub(crate) fn in_space<T: Parameter>([x, y]: [T; 2]) -> [T; 3] {
    [x, y, T::zero()]
}

impl<T: Parameter> From<Node<T>> for PlacedNode<T> {
    /// The node in space: nothing leads out of its plane.
    fn from(node: Node<T>) -> Self {
        let zero = T::zero();
        PlacedNode {
            position: in_space(node.position),
            held: node.held.union(Freedoms::SPACE.without(Freedoms::PLANE)),
            skew: node.along.map(|along| Skew::Along(in_space(along))),
            mass: node.mass,
            inertia: [zero, zero, node.inertia, zero, zero, zero],
            centre: in_space(node.centre),
        }
    }
}

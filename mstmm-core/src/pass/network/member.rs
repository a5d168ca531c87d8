//! The members of a network: elements between two points, with what joins them to these.

use crate::element::MemberElement;
use crate::number::Parameter;
use crate::pass::network::node::in_space;
use crate::pass::network::placement::SpatialEnd;
use mstmm_plan::Freedoms;

/// The end of a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End<T> {
    /// Index of the node.
    pub node: usize,
    /// The place of the end \[m\], tied rigidly to the node; none where it is the node's own.
    pub position: Option<[T; 2]>,
    /// Freedoms that the end does not share with the node, in the axes of the member: X along it, Y across, RZ of a hinge.
    pub released: Freedoms,
    /// The direction in which a spring or damper acts here, of any length; none where it is that from the first end to the second.
    pub along: Option<[T; 2]>,
}

impl<T> End<T> {
    /// An end at a node.
    pub fn of(node: usize) -> Self {
        End { node, position: None, released: Freedoms::NONE, along: None }
    }

    /// The end at another place of the body of its node.
    #[must_use]
    pub fn at(self, position: [T; 2]) -> Self {
        End { position: Some(position), ..self }
    }

    /// The end without the forces of some freedoms.
    #[must_use]
    pub fn releasing(self, released: Freedoms) -> Self {
        End { released, ..self }
    }

    /// The end of a spring or damper with a direction of its own, as where a lever turns it.
    #[must_use]
    pub fn along(self, direction: [T; 2]) -> Self {
        End { along: Some(direction), ..self }
    }
}

impl<T: Parameter> From<End<T>> for SpatialEnd<T> {
    fn from(End { node, position, released, along }: End<T>) -> Self {
        SpatialEnd { node, place: position.map(in_space), along: along.map(in_space), released }
    }
}

impl<T> From<usize> for End<T> {
    fn from(node: usize) -> Self {
        End::of(node)
    }
}

/// A member: an element between two ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member<E: MemberElement> {
    /// Its input and its output end.
    pub ends: [End<E::Parameter>; 2],
    /// What stands between the ends.
    pub element: E,
}

impl<E: MemberElement> Member<E> {
    /// A member from one end to another: a beam's cross section, a spring or a damper.
    pub fn new(from: impl Into<End<E::Parameter>>, to: impl Into<End<E::Parameter>>, element: impl Into<E>) -> Self {
        Member { ends: [from.into(), to.into()], element: element.into() }
    }

    /// The member with a direction along which it acts at both ends.
    #[must_use]
    pub fn along(self, direction: [E::Parameter; 2]) -> Self {
        Member { ends: self.ends.map(|end| end.along(direction)), ..self }
    }
}

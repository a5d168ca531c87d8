//! Parts of members: what stands in one plane between two nodes.

use crate::element::MemberElement;
use crate::model::MemberPlane;
use crate::pass::network::member::Member;
use crate::pass::network::placement::SpatialEnd;

/// A member in one plane, or a part of one: an element between two ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<E: MemberElement> {
    pub(crate) ends: [SpatialEnd<E::Parameter>; 2],
    pub(crate) plane: MemberPlane<E::Parameter>,
    pub(crate) element: E,
}

impl<E: MemberElement> From<Member<E>> for Part<E> {
    fn from(Member { ends, element }: Member<E>) -> Self {
        Part { ends: ends.map(SpatialEnd::from), plane: MemberPlane::Structure, element }
    }
}

//! The members of a network: elements between two points, with what joins them to these.

use crate::element::MemberElement;
use crate::number::{Frequency, Parameter, Scalar};
use crate::pass::network::node::Motions;
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
}

impl<T> End<T> {
    /// An end at a node.
    pub fn of(node: usize) -> Self {
        End { node, position: None, released: Freedoms::NONE }
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
    /// The direction of a spring or damper, of any length; none where it is that from the first end to the second.
    pub along: Option<[E::Parameter; 2]>,
    /// What stands between the ends.
    pub element: E,
}

impl<E: MemberElement> Member<E> {
    /// A member from one end to another: a beam's cross section, a spring or a damper.
    pub fn new(from: impl Into<End<E::Parameter>>, to: impl Into<End<E::Parameter>>, element: impl Into<E>) -> Self {
        Member { ends: [from.into(), to.into()], along: None, element: element.into() }
    }

    /// The member with a direction along which it acts.
    #[must_use]
    pub fn along(self, direction: [E::Parameter; 2]) -> Self {
        Member { along: Some(direction), ..self }
    }
}

/// Where a member stands: its length, and what the freedoms of its ends are of the motions of its nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Span<S> {
    pub(crate) length: S,
    /// Of each end, for displacements along and across the member and for the rotation: the parts of the motions of its node.
    rows: [[[S; 3]; 3]; 2],
}

impl<S: Scalar> Span<S> {
    /// The span between two places, whose nodes may stand elsewhere, in a given direction or in that from one place to the other.
    pub(crate) fn new<T>(
        places: [[S; 2]; 2],
        nodes: [[S; 2]; 2],
        along: Option<[S; 2]>,
        motions: [&Motions<T>; 2],
    ) -> Self
    where
        T: Parameter,
        S: Frequency<T>,
    {
        let [from, to] = places;
        let between = [to[0] - from[0], to[1] - from[1]];
        let norm = |[x, y]: [S; 2]| (x * x + y * y).sqrt();
        let length = norm(between);
        let (direction, size) = along.map_or((between, length), |along| (along, norm(along)));
        let [c, s] = direction.map(|part| part / size);
        let (zero, one) = (S::zero(), S::one());
        let rows = [0, 1].map(|end| {
            let [x, y] = [0, 1].map(|k| places[end][k] - nodes[end][k]);
            let rows = [[c, s, s * x - c * y], [-s, c, s * y + c * x], [zero, zero, one]];
            rows.map(|row| motions[end].parts_of(row))
        });
        Span { length, rows }
    }
}

/// A member that is built.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BuiltMember<E: MemberElement> {
    pub(crate) built: E::Built,
    pub(crate) freedoms: Freedoms,
    pub(crate) released: [Freedoms; 2],
    /// The places of its ends and of its nodes, and its direction: in extended precision the span follows from them anew, so that what
    /// is rigid stays so.
    pub(crate) places: [[E::Parameter; 2]; 2],
    pub(crate) nodes: [[E::Parameter; 2]; 2],
    pub(crate) along: Option<[E::Parameter; 2]>,
    pub(crate) span: Span<E::Parameter>,
}

impl<E: MemberElement> BuiltMember<E> {
    fn exact_span<S: Frequency<E::Parameter>>(&self, motions: [&Motions<E::Parameter>; 2]) -> Span<S> {
        let number = |places: [[E::Parameter; 2]; 2]| places.map(|place| place.map(S::from_parameter));
        let along = self.along.map(|along| along.map(S::from_parameter));
        Span::new(number(self.places), number(self.nodes), along, motions)
    }

    /// Its length.
    #[inline]
    pub(crate) fn length<S: Frequency<E::Parameter>>(&self, motions: [&Motions<E::Parameter>; 2]) -> S {
        if S::IS_EXTENDED { self.exact_span::<S>(motions).length } else { S::from_parameter(self.span.length) }
    }

    /// The freedom at a place among those that its ends have.
    #[inline]
    pub(crate) fn freedom(&self, place: usize) -> usize {
        let mut left = place;
        for (k, freedom) in FREEDOMS.into_iter().enumerate() {
            if self.freedoms.contains(freedom) {
                if left == 0 {
                    return k;
                }
                left -= 1;
            }
        }
        0
    }

    /// Whether an end does not share a freedom with its node.
    #[inline]
    pub(crate) fn releases(&self, end: usize, freedom: usize) -> bool {
        self.released[end].contains(FREEDOMS[freedom])
    }

    /// What a freedom of an end is of the motions of its node.
    #[inline]
    pub(crate) fn row<S: Frequency<E::Parameter>>(
        &self,
        end: usize,
        freedom: usize,
        motions: [&Motions<E::Parameter>; 2],
    ) -> [S; 3] {
        if S::IS_EXTENDED {
            return self.exact_span::<S>(motions).rows[end][freedom];
        }
        self.span.rows[end][freedom].map(S::from_parameter)
    }
}

/// The freedoms of an end in the axes of the member.
const FREEDOMS: [Freedoms; 3] = [Freedoms::X, Freedoms::Y, Freedoms::RZ];

/// Whether a place is finite.
pub(crate) fn is_finite<T: Parameter>(place: [T; 2]) -> bool {
    place.iter().all(|part| part.to_f64().is_finite())
}

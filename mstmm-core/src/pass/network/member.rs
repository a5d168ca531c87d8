//! The members of a network: elements between two points, with what joins them to these.

use crate::element::MemberElement;
use crate::number::{Frequency, Parameter, Real, Scalar};
use crate::pass::network::frame::{moved, norm, turned, unit};
use crate::pass::network::node::{Motions, Node};
use crate::structure::JoinedEnd;
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

impl<T: Parameter> End<T> {
    /// The end with the axes of the plane, unless it has a direction.
    pub(crate) fn in_axes(self) -> Self {
        End { along: Some(self.along.unwrap_or([T::one(), T::zero()])), ..self }
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

/// Where a member stands: its length, and what the freedoms of its ends are of the motions of its nodes.
#[derive(Clone, Copy, Debug)]
struct Span<S> {
    length: S,
    /// Of each end, for displacements along and across the member and for the rotation: the parts of the motions of its node.
    rows: [[[S; 3]; 3]; 2],
}

impl<S: Scalar> Span<S> {
    /// The span between two ends, from the one to the other or in directions of their own.
    fn new<T>(ends: &[PlacedEnd<T>; 2], motions: [&Motions<T>; 2]) -> Self
    where
        T: Parameter,
        S: Frequency<T>,
    {
        let rows = [0, 1].map(|end| rows_of(ends, end, motions[end]));
        Span { length: norm(between(ends)), rows }
    }
}

/// The vector from one end to the other.
fn between<T: Parameter, S: Frequency<T>>(ends: &[PlacedEnd<T>; 2]) -> [S; 2] {
    let [from, to] = [&ends[0], &ends[1]].map(|end| end.place.map(S::from_parameter));
    [to[0] - from[0], to[1] - from[1]]
}

/// The vector that gives an end its x axis, of any length: its own, or that from the one end to the other.
fn vector_of<T: Parameter, S: Frequency<T>>(ends: &[PlacedEnd<T>; 2], end: usize) -> [S; 2] {
    ends[end].along.map_or_else(|| between(ends), |along| along.map(S::from_parameter))
}

/// The direction of the x axis of an end.
fn direction_of<T: Parameter, S: Frequency<T>>(ends: &[PlacedEnd<T>; 2], end: usize) -> [S; 2] {
    unit(vector_of(ends, end))
}

/// Where an end is from its node.
fn offset_of<T: Parameter, S: Frequency<T>>(PlacedEnd { place, node, .. }: &PlacedEnd<T>) -> [S; 2] {
    [0, 1].map(|k| S::from_parameter(place[k]) - S::from_parameter(node[k]))
}

/// What displacements of an end along and across the member and its rotation are of the motions of its node.
fn rows_of<T: Parameter, S: Frequency<T>>(ends: &[PlacedEnd<T>; 2], end: usize, motions: &Motions<T>) -> [[S; 3]; 3] {
    let (zero, one) = (S::zero(), S::one());
    let [c, s]: [S; 2] = direction_of(ends, end);
    let [x, y]: [S; 2] = offset_of(&ends[end]);
    [[c, s, s * x - c * y], [-s, c, s * y + c * x], [zero, zero, one]].map(|row| motions.parts_of(row))
}

/// A real number of two words in numbers of as many: geometry is real, whatever the frequency is.
fn exact<T: Real, S: Scalar>(number: T) -> S {
    let [hi, lo] = number.words();
    S::from_f64(hi) + S::from_f64(lo)
}

/// Where a member stands, and how it is joined to its nodes.
#[derive(Clone, Copy, Debug)]
pub struct Placement<T> {
    pub(crate) freedoms: Freedoms,
    ends: [PlacedEnd<T>; 2],
    span: Span<T>,
    /// Whether it is a rigid joint by which a node hangs on another one: what it ties is one unknown.
    pub(crate) is_tie: bool,
}

/// The end of a member: its place and that of its node, and the direction in which it acts, if that is not along the member. In extended
/// precision the span follows from them anew, so that what is rigid stays so.
#[derive(Clone, Copy, Debug)]
struct PlacedEnd<T> {
    index: usize,
    place: [T; 2],
    /// The place of its node.
    node: [T; 2],
    along: Option<[T; 2]>,
    released: Freedoms,
    /// Whether the node has no motions.
    rests: bool,
}

impl<T: Real> Placement<T> {
    /// No place yet.
    pub(crate) fn nowhere() -> Self {
        let origin = [T::zero(); 2];
        let end =
            PlacedEnd { index: 0, place: origin, node: origin, along: None, released: Freedoms::NONE, rests: false };
        Placement {
            freedoms: Freedoms::NONE,
            ends: [end; 2],
            span: Span { length: T::zero(), rows: [[[T::zero(); 3]; 3]; 2] },
            is_tie: false,
        }
    }

    /// The placement of a member with some freedoms at each end, between nodes with these motions.
    pub(crate) fn new(freedoms: Freedoms, ends: [&End<T>; 2], nodes: [&Node<T>; 2], motions: [&Motions<T>; 2]) -> Self {
        let ends = [0, 1].map(|k| {
            let End { position, along, released, .. } = *ends[k];
            let node = nodes[k].position;
            PlacedEnd {
                index: ends[k].node,
                place: position.unwrap_or(node),
                node,
                along,
                released,
                rests: motions[k].count == 0,
            }
        });
        let span = Span::new(&ends, motions);
        Placement { freedoms, ends, span, is_tie: false }
    }

    /// Its length as a parameter.
    pub(crate) fn own_length(&self) -> T {
        self.span.length
    }

    /// Its length.
    #[inline]
    pub(crate) fn length<S: Frequency<T>>(&self) -> S {
        if S::IS_EXTENDED {
            exact(norm(between::<T, T::Extended>(&self.ends)))
        } else {
            S::from_parameter(self.span.length)
        }
    }

    /// Whether no row of an end has been rounded: the end stands at its node, and its axes are those of the plane.
    fn is_exact(&self, end: usize) -> bool {
        let [x, y]: [T; 2] = vector_of(&self.ends, end);
        let PlacedEnd { place, node, .. } = self.ends[end];
        place == node && (x.vanishes() || y.vanishes())
    }

    /// Where its ends are joined, given the motions of the nodes at which they leave; an end at rest leaves at the node of the other one.
    #[inline]
    pub(crate) fn joined<S: Frequency<T>>(&self, motions: [&Motions<T>; 2]) -> [JoinedEnd<S>; 2] {
        [0, 1].map(|end| JoinedEnd {
            released: self.ends[end].released,
            rests: self.ends[end].rests,
            rows: if S::IS_EXTENDED && !self.ends[end].rests && !self.is_exact(end) {
                rows_of::<T, T::Extended>(&self.ends, end, motions[end]).map(|row| row.map(exact))
            } else {
                self.span.rows[end].map(|row| row.map(S::from_parameter))
            },
        })
    }
}

impl<T: Real> Placement<T> {
    /// The direction of the x axis of an end; what acts on rotations alone needs none, and has that of the plane.
    pub(crate) fn axis<S: Frequency<T>>(&self, end: usize) -> [S; 2] {
        if self.freedoms.is(Freedoms::RZ) { [S::one(), S::zero()] } else { direction_of(&self.ends, end) }
    }

    /// The vector that gives an end its x axis, of any length.
    pub(crate) fn vector<S: Frequency<T>>(&self, end: usize) -> [S; 2] {
        vector_of(&self.ends, end)
    }

    /// Where an end is from its node.
    pub(crate) fn offset<S: Frequency<T>>(&self, end: usize) -> [S; 2] {
        offset_of(&self.ends[end])
    }

    /// The displacements of the place of an end, as its node has them, in the axes of the member.
    pub(crate) fn tied<S: Frequency<T>>(&self, end: usize, node: [S; 3]) -> [S; 3] {
        turned(moved(node, self.offset(end)), self.axis(end))
    }

    /// Of each end, for displacements along and across the member and for the rotation: the parts of the motions of its node.
    pub(crate) fn rows(&self) -> [[[T; 3]; 3]; 2] {
        self.span.rows
    }

    /// The node of an end.
    pub(crate) fn node_of(&self, end: usize) -> usize {
        self.ends[end].index
    }

    /// The place of an end; of a motion of a path any.
    pub(crate) fn place_of(&self, end: usize) -> [T; 2] {
        self.ends[end].place
    }

    /// The vector that gives an end an x axis of its own, not that from one end to the other.
    pub(crate) fn along(&self, end: usize) -> Option<[T; 2]> {
        self.ends[end].along
    }

    /// Whether the node of an end has no motions.
    pub(crate) fn rests(&self, end: usize) -> bool {
        self.ends[end].rests
    }

    /// The freedoms that an end does not share with its node.
    pub(crate) fn released(&self, end: usize) -> Freedoms {
        self.ends[end].released
    }
}

/// Whether a place is finite.
pub(crate) fn is_finite<T: Parameter>(place: [T; 2]) -> bool {
    place.iter().all(|part| part.to_f64().is_finite())
}

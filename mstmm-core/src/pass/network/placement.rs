//! Where a member stands, and what the displacements of its ends are of the motions of its nodes.

use crate::model::MemberPlane;
use crate::number::{Frequency, Parameter, Real, Scalar};
use crate::pass::network::motions::Motions;
use crate::pass::network::placed_node::PlacedNode;
use crate::pass::network::vector::{Axes, Six, difference, is_exact, moved, norm, unit, with_axes_across};
use crate::structure::{JoinedEnd, MOST_MOTIONS};
use mstmm_plan::Freedoms;

/// The end of a member, or of a part of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SpatialEnd<T> {
    /// Index of the node.
    pub(crate) node: usize,
    /// Its place, tied rigidly to the node; none where it is the node's own.
    pub(crate) place: Option<[T; 3]>,
    /// The direction of its x axis, of any length; none where it is that from the first end to the second.
    pub(crate) along: Option<[T; 3]>,
    /// Freedoms that it does not share with the node, in the axes of the part: X along it, Y across, RZ of a hinge.
    pub(crate) released: Freedoms,
}

impl<T: Parameter> SpatialEnd<T> {
    /// The end with the axes of the structure, unless it has a direction.
    pub(crate) fn in_axes(self) -> Self {
        SpatialEnd { along: Some(self.along.unwrap_or([T::one(), T::zero(), T::zero()])), ..self }
    }
}

/// Where a member stands: its length, and what the freedoms of its ends are of the motions of its nodes.
#[derive(Clone, Copy, Debug)]
struct Span<S> {
    length: S,
    /// Of each end, for displacements along and across the member and for the rotation: the parts of the motions of its node.
    rows: [[Six<S>; 3]; 2],
}

/// Where a member stands, and how it is joined to its nodes.
#[derive(Clone, Copy, Debug)]
pub struct Placement<T> {
    pub(crate) freedoms: Freedoms,
    plane: MemberPlane<T>,
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
    place: [T; 3],
    /// The place of its node.
    node: [T; 3],
    along: Option<[T; 3]>,
    released: Freedoms,
    /// Whether the node has no motions.
    rests: bool,
}

/// A real number of two words in numbers of as many: geometry is real, whatever the frequency is.
fn exact<T: Real, S: Scalar>(number: T) -> S {
    let [hi, lo] = number.words();
    S::from_f64(hi) + S::from_f64(lo)
}

impl<T: Real> Placement<T> {
    /// No place yet.
    pub(crate) fn nowhere() -> Self {
        let origin = [T::zero(); 3];
        let end =
            PlacedEnd { index: 0, place: origin, node: origin, along: None, released: Freedoms::NONE, rests: false };
        Placement {
            freedoms: Freedoms::NONE,
            plane: MemberPlane::Structure,
            ends: [end; 2],
            span: Span { length: T::zero(), rows: [[[T::zero(); MOST_MOTIONS]; 3]; 2] },
            is_tie: false,
        }
    }

    /// The placement of a member, or a part of one, with some freedoms at each end, between nodes with these motions.
    pub(crate) fn new(
        (freedoms, plane): (Freedoms, MemberPlane<T>),
        ends: &[SpatialEnd<T>; 2],
        nodes: [&PlacedNode<T>; 2],
        motions: [&Motions<T>; 2],
    ) -> Self {
        let ends = [0, 1].map(|k| {
            let SpatialEnd { node: index, place, along, released } = ends[k];
            let node = nodes[k].position;
            PlacedEnd { index, place: place.unwrap_or(node), node, along, released, rests: motions[k].count == 0 }
        });
        let nowhere = Placement { freedoms, plane, ends, ..Placement::nowhere() };
        let rows = [0, 1].map(|end| nowhere.rows_of(end, motions[end]));
        Placement { span: Span { length: norm(nowhere.between::<T>()), rows }, ..nowhere }
    }

    /// Its length as a parameter.
    pub(crate) fn own_length(&self) -> T {
        self.span.length
    }

    /// Its length.
    #[inline]
    pub(crate) fn length<S: Frequency<T>>(&self) -> S {
        if S::IS_EXTENDED { exact(norm(self.between::<T::Extended>())) } else { S::from_parameter(self.span.length) }
    }

    /// Whether no row of an end has been rounded: the end stands at its node, and its axes are those of the structure.
    fn is_exact(&self, end: usize) -> bool {
        let vector: [T; 3] = self.vector(end);
        let PlacedEnd { place, node, .. } = self.ends[end];
        place == node && vector.iter().filter(|part| !part.vanishes()).count() <= 1 && is_exact(&self.plane)
    }

    /// Where its ends are joined, given the motions of the nodes at which they leave; an end at rest leaves at the node of the other one.
    #[inline]
    pub(crate) fn joined<S: Frequency<T>>(&self, motions: [&Motions<T>; 2]) -> [JoinedEnd<S>; 2] {
        [0, 1].map(|end| JoinedEnd {
            released: self.ends[end].released,
            rests: self.ends[end].rests,
            rows: if S::IS_EXTENDED && !self.ends[end].rests && !self.is_exact(end) {
                self.rows_of::<T::Extended>(end, motions[end]).map(|row| row.map(exact))
            } else {
                self.span.rows[end].map(|row| row.map(S::from_parameter))
            },
        })
    }

    /// The vector from one end to the other.
    fn between<S: Frequency<T>>(&self) -> [S; 3] {
        let [from, to] = self.ends.each_ref().map(|end| end.place.map(S::from_parameter));
        difference(from, to)
    }

    /// What displacements of an end along and across the member and its rotation are of the motions of its node.
    fn rows_of<S: Frequency<T>>(&self, end: usize, motions: &Motions<T>) -> [Six<S>; 3] {
        self.axes::<S>(end).rows(self.offset(end)).map(|row| motions.parts_of(row))
    }

    /// The axes of an end; what acts on rotations of the plane alone needs none, and has those of the plane.
    pub(crate) fn axes<S: Frequency<T>>(&self, end: usize) -> Axes<S> {
        let turns_in_plane = self.freedoms.is(Freedoms::RZ) && self.plane == MemberPlane::Structure;
        let along = if turns_in_plane { [S::one(), S::zero(), S::zero()] } else { unit(self.vector(end)) };
        Axes::new(&self.plane, along)
    }

    /// The vector that gives an end its x axis, of any length: its own, or that from the one end to the other.
    pub(crate) fn vector<S: Frequency<T>>(&self, end: usize) -> [S; 3] {
        self.ends[end].along.map_or_else(|| self.between(), |along| along.map(S::from_parameter))
    }

    /// Where an end is from its node.
    pub(crate) fn offset<S: Frequency<T>>(&self, end: usize) -> [S; 3] {
        let PlacedEnd { place, node, .. } = self.ends[end];
        difference(node.map(S::from_parameter), place.map(S::from_parameter))
    }

    /// The displacements of the place of an end, as its node has them, in the axes of the member.
    pub(crate) fn tied<S: Frequency<T>>(&self, end: usize, node: Six<S>) -> [S; 3] {
        self.axes(end).of(moved(node, self.offset(end)))
    }

    /// Of each end, for displacements along and across the member and for the rotation: the parts of the motions of its node.
    pub(crate) fn rows(&self) -> [[Six<T>; 3]; 2] {
        self.span.rows
    }

    /// The plane in which it moves.
    pub(crate) fn plane(&self) -> MemberPlane<T> {
        self.plane
    }

    /// Which part of its member it is: 0 that in the plane of x and y, or its only one, 1 that of x and z, 2 its rotation about x.
    pub(crate) fn part(&self) -> usize {
        match self.plane {
            MemberPlane::Structure | MemberPlane::Along | MemberPlane::First(_) => 0,
            MemberPlane::Second(_) => 1,
            MemberPlane::About => 2,
        }
    }

    /// The axes x, y and z of the member, as drawings show them; none of what acts along one axis of space, and where there is no direction.
    pub(crate) fn drawn_axes(&self) -> Option<[[T; 3]; 3]> {
        let axes = match self.plane {
            MemberPlane::Structure | MemberPlane::First(_) | MemberPlane::Second(_) => self.axes_of_member::<T>(0),
            MemberPlane::Along | MemberPlane::About => return None,
        };
        axes.iter().all(|axis| is_finite(*axis)).then_some(axes)
    }

    /// The axes x, y and z of the member at an end; of what has one motion x and any axes across it.
    pub(crate) fn axes_of_member<S: Frequency<T>>(&self, end: usize) -> [[S; 3]; 3] {
        let Axes { along, across, normal } = self.axes::<S>(end);
        match self.plane {
            MemberPlane::Structure | MemberPlane::First(_) => [along, across, normal],
            MemberPlane::Second(_) => [along, normal.map(|part| -part), across],
            MemberPlane::Along | MemberPlane::About => with_axes_across(along, self.vector::<T>(end)),
        }
    }

    /// The freedoms of an end that it has and does not share with its node.
    pub(crate) fn released_freedoms(&self, end: usize) -> Freedoms {
        self.released(end).intersection(self.freedoms)
    }

    /// The node of an end.
    pub(crate) fn node_of(&self, end: usize) -> usize {
        self.ends[end].index
    }

    /// The place of an end; of a motion of a path any.
    pub(crate) fn place_of(&self, end: usize) -> [T; 3] {
        self.ends[end].place
    }

    /// The vector that gives an end an x axis of its own, not that from one end to the other.
    pub(crate) fn along(&self, end: usize) -> Option<[T; 3]> {
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
pub(crate) fn is_finite<T: Parameter, const N: usize>(place: [T; N]) -> bool {
    place.iter().all(|part| part.to_f64().is_finite())
}

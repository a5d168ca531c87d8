//! Vectors in space, and the six displacements of a node: x, y and the rotation about z first, as in the plane, then z and the rotations about
//! x and y.

use crate::model::MemberPlane;
use crate::number::{Frequency, Parameter, Real, Scalar, Truth};
use crate::structure::MOST_MOTIONS;

/// Displacements or forces of a node, in the order of [`Freedoms::EACH`](mstmm_plan::Freedoms::EACH).
pub(crate) type Six<S> = [S; MOST_MOTIONS];

/// The places of the displacements, and those of the rotations, about x, y and z.
pub(crate) const DISPLACEMENTS: [usize; 3] = [0, 1, 3];
pub(crate) const ROTATIONS: [usize; 3] = [4, 5, 2];

/// A product, where neither factor is zero for all frequencies: in the plane most are.
fn product<S: Scalar>(one: S, other: S) -> S {
    if one.is_constant_zero() || other.is_constant_zero() { S::zero() } else { one * other }
}

/// The product of two vectors.
pub(crate) fn dot<S: Scalar>(one: [S; 3], other: [S; 3]) -> S {
    let [x, y, z] = [0, 1, 2].map(|k| product(one[k], other[k]));
    x + y + z
}

/// The vector across two vectors.
pub(crate) fn cross<S: Scalar>([x, y, z]: [S; 3], [u, v, w]: [S; 3]) -> [S; 3] {
    [product(y, w) - product(z, v), product(z, u) - product(x, w), product(x, v) - product(y, u)]
}

/// The length of a vector.
pub(crate) fn norm<S: Scalar>(vector: [S; 3]) -> S {
    dot(vector, vector).sqrt()
}

/// The direction of a vector.
pub(crate) fn unit<S: Scalar>(vector: [S; 3]) -> [S; 3] {
    let size = norm(vector);
    vector.map(|part| if part.is_constant_zero() { part } else { part / size })
}

/// A direction with two axes across it, given a vector that leads along it: that of them is in the plane of x and y where it is not along z.
pub(crate) fn with_axes_across<S: Scalar, T: Real>(along: [S; 3], vector: [T; 3]) -> [[S; 3]; 3] {
    let [x, y, z] = vector.map(|part| part.words()[0].abs());
    let (zero, one) = (S::zero(), S::one());
    // not near its own direction
    let up = if z > x.max(y) { [one, zero, zero] } else { [zero, zero, one] };
    let across = unit(cross(up, along));
    [along, across, cross(along, across)]
}

/// The difference of two places.
pub(crate) fn difference<S: Scalar>(from: [S; 3], to: [S; 3]) -> [S; 3] {
    [0, 1, 2].map(|k| to[k] - from[k])
}

/// The displacements, or the forces, among those of a node.
pub(crate) fn displacements<S: Scalar>(six: Six<S>) -> [S; 3] {
    DISPLACEMENTS.map(|place| six[place])
}

/// The rotations, or the moments, among those of a node.
pub(crate) fn rotations<S: Scalar>(six: Six<S>) -> [S; 3] {
    ROTATIONS.map(|place| six[place])
}

/// Displacements and rotations, or forces and moments, in the order of a node.
pub(crate) fn six<S: Scalar>([x, y, z]: [S; 3], [about_x, about_y, about_z]: [S; 3]) -> Six<S> {
    [x, y, about_z, z, about_x, about_y]
}

/// The sum of two vectors.
pub(crate) fn sum<S: Scalar>(one: [S; 3], other: [S; 3]) -> [S; 3] {
    [0, 1, 2].map(|k| one[k] + other[k])
}

/// The displacements of a place that is tied to a node at a distance.
pub(crate) fn moved<S: Scalar>(node: Six<S>, to: [S; 3]) -> Six<S> {
    let turned = rotations(node);
    six(sum(displacements(node), cross(turned, to)), turned)
}

/// A force at a distance from a node with its moment about that.
pub(crate) fn at_node<S: Scalar>(forces: Six<S>, from: [S; 3]) -> Six<S> {
    let force = displacements(forces);
    six(force, sum(rotations(forces), cross(from, force)))
}

/// The axes of a part of a member: along it, the direction of its deflection, and the axis about which it turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes<S> {
    pub(crate) along: [S; 3],
    pub(crate) across: [S; 3],
    pub(crate) normal: [S; 3],
}

impl<S: Scalar> Axes<S> {
    /// The axes in a plane, given the direction of the x axis of the member.
    pub(crate) fn new<T: Parameter>(plane: &MemberPlane<T>, along: [S; 3]) -> Self
    where
        S: Frequency<T>,
    {
        let (zero, one) = ([S::zero(); 3], S::one());
        let y_axis = |up: &[T; 3]| unit(cross(up.map(S::from_parameter), along));
        match plane {
            MemberPlane::Structure => {
                let [x, y, _] = along;
                Axes { along, across: [-y, x, S::zero()], normal: [S::zero(), S::zero(), one] }
            }
            MemberPlane::First(up) => {
                let across = y_axis(up);
                Axes { along, across, normal: cross(along, across) }
            }
            MemberPlane::Second(up) => {
                let y = y_axis(up);
                Axes { along, across: cross(along, y), normal: y.map(|part| -part) }
            }
            MemberPlane::Along => Axes { along, across: zero, normal: zero },
            MemberPlane::About => Axes { along, across: zero, normal: along },
        }
    }

    /// What is along, what is across, and what turns, of the six of a node.
    pub(crate) fn of(&self, node: Six<S>) -> [S; 3] {
        let (moved, turned) = (displacements(node), rotations(node));
        [dot(self.along, moved), dot(self.across, moved), dot(self.normal, turned)]
    }

    /// The six of a node of what is along, across, and turns.
    pub(crate) fn back(&self, [along, across, turn]: [S; 3]) -> Six<S> {
        let times = |direction: [S; 3], size: S| direction.map(|part| product(part, size));
        six(sum(times(self.along, along), times(self.across, across)), times(self.normal, turn))
    }

    /// What a displacement along, one across and a rotation at a distance from a node are of its six.
    pub(crate) fn rows(&self, offset: [S; 3]) -> [Six<S>; 3] {
        let zero = [S::zero(); 3];
        [
            six(self.along, cross(offset, self.along)),
            six(self.across, cross(offset, self.across)),
            six(zero, self.normal),
        ]
    }
}

/// Whether the axes in a plane are exact, if the x axis of the member leads along one of the structure.
pub(crate) fn is_exact<T: Parameter>(plane: &MemberPlane<T>) -> bool {
    match plane {
        MemberPlane::First(up) | MemberPlane::Second(up) => {
            up.iter().filter(|part| !part.vanishes().all()).count() <= 1
        }
        MemberPlane::Structure | MemberPlane::Along | MemberPlane::About => true,
    }
}

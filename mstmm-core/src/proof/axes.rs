//! The axes of a member, and the directions in which a node moves, as balls.

use crate::element::Exact;
use crate::model::{MemberPlane, Skew, across};
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::Number;
use crate::proof::row::{difference, is_one, is_zero};
use crate::proof::word::Word;

/// A vector.
pub(crate) type Vector<N> = [Ball<N>; 3];

/// A product: exact where a factor is 0, 1 or -1.
fn times<N: Level>(one: Ball<N>, other: Ball<N>) -> Ball<N> {
    if is_zero(&one) || is_zero(&other) {
        Ball::of(0.0)
    } else if is_one(&one) {
        other
    } else if is_one(&other) {
        one
    } else if is_one(&-one) {
        -other
    } else if is_one(&-other) {
        -one
    } else {
        one * other
    }
}

/// A sum: exact where a term is 0.
fn plus<N: Level>(one: Ball<N>, other: Ball<N>) -> Ball<N> {
    if is_zero(&one) {
        other
    } else if is_zero(&other) {
        one
    } else {
        one + other
    }
}

/// The product of two vectors.
pub(crate) fn dot<N: Level>(one: &Vector<N>, other: &Vector<N>) -> Ball<N> {
    one.iter().zip(other).fold(Ball::of(0.0), |sum, (one, other)| plus(sum, times(*one, *other)))
}

/// A part of the vector across two vectors.
pub(crate) fn part_across<N: Level>(one: &Vector<N>, other: &Vector<N>, axis: usize) -> Ball<N> {
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
    plus(times(one[next], other[last]), -times(one[last], other[next]))
}

/// The vector across two vectors.
fn cross<N: Level>(one: &Vector<N>, other: &Vector<N>) -> Vector<N> {
    [part_across(one, other, 0), part_across(one, other, 1), part_across(one, other, 2)]
}

/// The difference of two places.
pub(crate) fn difference_of<N: Level>(from: [Exact; 3], to: [Exact; 3]) -> Vector<N> {
    let ([x, y, z], [to_x, to_y, to_z]) = (from, to);
    [difference(x, to_x), difference(y, to_y), difference(z, to_z)]
}

/// The direction of a vector of any length, and that length. Along an axis all are exact.
pub(crate) fn direction<N: Level>(vector: Vector<N>) -> (Vector<N>, Ball<N>) {
    let is_negative = |part: &Ball<N>| part.mid.leading().first() < 0.0;
    let mut others = vector.iter().enumerate().filter(|(_, part)| !is_zero(part));
    if let (Some((axis, part)), None) = (others.next(), others.next()) {
        let mut along = [Ball::of(0.0); 3];
        along[axis] = Ball::of(if is_negative(part) { -1.0 } else { 1.0 });
        return (along, if is_negative(part) { -*part } else { *part });
    }
    let length = dot(&vector, &vector).root();
    let inverse = length.inverse();
    let [x, y, z] = vector;
    ([times(x, inverse), times(y, inverse), times(z, inverse)], length)
}

/// The directions in which a skew node moves: they span all of its displacements.
pub(crate) fn directions<N: Level>(skew: Skew<Exact>) -> [Vector<N>; 2] {
    match skew {
        Skew::Along(along) => [along.map(Ball::of_pair), [Ball::of(0.0); 3]],
        Skew::Normal(normal) => across(normal.map(Ball::of_pair), normal.map(|[hi, _]| hi.abs()), Ball::of(0.0)),
    }
}

/// The axes of a member, or of a part of one: along it, the direction of its deflection, and the axis about which it turns.
pub(crate) struct Axes<N: Number> {
    pub(crate) along: Vector<N>,
    pub(crate) across: Vector<N>,
    pub(crate) normal: Vector<N>,
}

impl<N: Level> Axes<N> {
    /// x, y and z of the structure.
    pub(crate) fn of_structure() -> Self {
        let (zero, one) = (Ball::of(0.0), Ball::of(1.0));
        Axes { along: [one, zero, zero], across: [zero, one, zero], normal: [zero, zero, one] }
    }

    /// The axes in a plane, given the direction of the x axis of the member.
    pub(crate) fn new(plane: &MemberPlane<Exact>, along: Vector<N>) -> Self {
        let zero = [Ball::of(0.0); 3];
        // across `up` and the member: a part that vanishes is zero exactly, and not what rounding leaves of it
        let y_axis = |up: &[Exact; 3]| direction(cross(&up.map(Ball::of_pair), &along)).0;
        match plane {
            MemberPlane::Structure => {
                let [x, y, _] = along;
                Axes { along, across: [-y, x, Ball::of(0.0)], ..Axes::of_structure() }
            }
            MemberPlane::First(up) => {
                let across = y_axis(up);
                Axes { along, across, normal: cross(&along, &across) }
            }
            MemberPlane::Second(up) => {
                let y = y_axis(up);
                let [a, b, c] = y;
                Axes { along, across: cross(&along, &y), normal: [-a, -b, -c] }
            }
            MemberPlane::Along => Axes { along, across: zero, normal: zero },
            MemberPlane::About => Axes { along, across: zero, normal: along },
        }
    }
}

//! Vectors of the plane of the paper: x to the right, y downwards.

/// A place on the paper, or a way on it.
pub(crate) type Vector = [f64; 2];

/// Shortest way that has a direction.
const SHORT: f64 = 1e-6;

pub(crate) fn plus(a: Vector, b: Vector, factor: f64) -> Vector {
    [a[0] + factor * b[0], a[1] + factor * b[1]]
}

pub(crate) fn between(a: Vector, b: Vector, part: f64) -> Vector {
    [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn distance(a: Vector, b: Vector) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// A quarter of a turn on, from x towards y of the paper.
pub(crate) fn turned(a: Vector) -> Vector {
    [-a[1], a[0]]
}

/// The direction of a vector; none of one that is too short.
pub(crate) fn direction(a: Vector) -> Option<Vector> {
    let length = a[0].hypot(a[1]);
    (length > SHORT).then(|| [a[0] / length, a[1] / length])
}

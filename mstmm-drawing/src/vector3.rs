//! Vectors in space.

/// A place in space, or a way there.
pub(crate) type Vector3 = [f64; 3];

/// Shortest way that has a direction, as a part of its largest entry.
const SHORT: f64 = 1e-12;

pub(crate) fn dot3(a: Vector3, b: Vector3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross([x, y, z]: Vector3, [u, v, w]: Vector3) -> Vector3 {
    [y * w - z * v, z * u - x * w, x * v - y * u]
}

pub(crate) fn plus3(a: Vector3, b: Vector3, factor: f64) -> Vector3 {
    [0, 1, 2].map(|k| a[k] + factor * b[k])
}

pub(crate) fn times(a: Vector3, factor: f64) -> Vector3 {
    a.map(|part| factor * part)
}

pub(crate) fn length3(a: Vector3) -> f64 {
    a[0].hypot(a[1]).hypot(a[2])
}

/// The direction of a vector; none of one without length, or that is no vector.
pub(crate) fn direction3(a: Vector3) -> Option<Vector3> {
    let size = a.iter().fold(0.0, |most: f64, part| most.max(part.abs()));
    let scaled = a.map(|part| part / size);
    let length = length3(scaled);
    (size.is_normal() && length > SHORT && length.is_finite()).then(|| scaled.map(|part| part / length))
}

/// Two directions across a third one, of length 1: the first as level as it can be.
pub(crate) fn across(a: Vector3) -> [Vector3; 2] {
    let level = direction3([-a[1], a[0], 0.0]).filter(|_| a[0].hypot(a[1]) > 1e-6).unwrap_or([1.0, 0.0, 0.0]);
    [level, cross(a, level)]
}

//! Where members and nodes move in space.
//!
//! A member in space is its parts: it stretches and bends in one plane through its axis, bends in the plane across that, and turns about its
//! axis. Each part moves in a plane of its own, as a member of a plane structure does.

use crate::number::Scalar;

/// The plane of a member, or of a part of one, given the x axis of the member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MemberPlane<T> {
    /// x and y of the structure.
    Structure,
    /// x and y of the member, whose z axis is a vector made normal to x.
    First([T; 3]),
    /// x and z of the member, with the same vector: it turns about -y.
    Second([T; 3]),
    /// None: it moves along x of the member.
    Along,
    /// None: it turns about x of the member.
    About,
}

impl<T> MemberPlane<T> {
    /// The plane in other numbers.
    pub(crate) fn map<S>(self, number: impl Fn(T) -> S) -> MemberPlane<S> {
        match self {
            MemberPlane::Structure => MemberPlane::Structure,
            MemberPlane::First(up) => MemberPlane::First(up.map(number)),
            MemberPlane::Second(up) => MemberPlane::Second(up.map(number)),
            MemberPlane::Along => MemberPlane::Along,
            MemberPlane::About => MemberPlane::About,
        }
    }
}

/// How a node moves where that is not along axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Skew<T> {
    /// Along a direction, held across it.
    Along([T; 3]),
    /// Across a direction, held along it.
    Normal([T; 3]),
}

impl<T> Skew<T> {
    /// Its direction, of any length.
    pub(crate) fn direction(&self) -> &[T; 3] {
        match self {
            Skew::Along(direction) | Skew::Normal(direction) => direction,
        }
    }

    /// The skew in other numbers.
    pub(crate) fn map<S>(self, number: impl Fn(T) -> S) -> Skew<S> {
        match self {
            Skew::Along(direction) => Skew::Along(direction.map(number)),
            Skew::Normal(direction) => Skew::Normal(direction.map(number)),
        }
    }
}

/// Two vectors across a third one, given the sizes of its parts: each has two of these parts, so that it is exact, and neither is small.
pub(crate) fn across<T: Copy + core::ops::Neg<Output = T>>([x, y, z]: [T; 3], sizes: [f64; 3], zero: T) -> [[T; 3]; 2] {
    let [of_x, of_y, of_z] = sizes;
    if of_x >= of_y && of_x >= of_z {
        [[-y, x, zero], [-z, zero, x]]
    } else if of_y >= of_z {
        [[y, -x, zero], [zero, -z, y]]
    } else {
        [[z, zero, -x], [zero, z, -y]]
    }
}

/// Sine of the angle between the axis of a member and its `up` up to which that says no direction: rounding of both decides it there.
pub(crate) const PARALLEL: f64 = 1e-9;

/// `up` of a member that names none, and of one along that.
const UP: [f64; 3] = [0.0, 0.0, 1.0];
const UP_OF_VERTICAL: [f64; 3] = [1.0, 0.0, 0.0];

/// The vector that is made the z axis of a member with an x axis: the one that it names, else z of space. Where a member whose planes are alike
/// leads along z and names none it is x of space.
///
/// # Errors
/// The sine of the angle between both, where the member leads along the vector.
pub(crate) fn up_of(along: [f64; 3], named: Option<[f64; 3]>, is_symmetric: bool) -> Result<[f64; 3], f64> {
    let sine = |up: [f64; 3]| {
        let ([x, y, z], [u, v, w]) = (unit(along), unit(up));
        norm([y * w - z * v, z * u - x * w, x * v - y * u])
    };
    let up = match named {
        None if is_symmetric && sine(UP) <= PARALLEL => UP_OF_VERTICAL,
        named => named.unwrap_or(UP),
    };
    let sine = sine(up);
    if sine <= PARALLEL { Err(sine) } else { Ok(up) }
}

/// The length of a vector whose parts are at most some 1.
fn norm(vector: [f64; 3]) -> f64 {
    Scalar::sqrt(vector.iter().map(|part| part * part).sum::<f64>())
}

/// The direction of a vector, whose squares may be out of range.
fn unit(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0, |largest: f64, part| largest.max(part.abs()));
    let scaled = vector.map(|part| part / largest);
    let size = norm(scaled);
    scaled.map(|part| part / size)
}

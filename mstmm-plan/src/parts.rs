//! The parts of a member in space, and what their freedoms are in the member.

use crate::freedom::Freedoms;

/// Most parts of a member: the plane of its x and y, that of x and z, and the rotation about x.
pub const MOST_PARTS: usize = 3;

/// What X, Y and RZ of each part are in the member.
const OF_PARTS: [[Freedoms; 3]; MOST_PARTS] = [
    [Freedoms::X, Freedoms::Y, Freedoms::RZ],
    [Freedoms::NONE, Freedoms::Z, Freedoms::RY],
    [Freedoms::NONE, Freedoms::NONE, Freedoms::RX],
];

/// What freedoms of a part are in its member.
///
/// ```
/// use mstmm_plan::{Freedoms, freedoms_of_part};
/// assert_eq!(freedoms_of_part(1, Freedoms::PLANE), Freedoms::Z.union(Freedoms::RY));
/// ```
pub const fn freedoms_of_part(part: usize, own: Freedoms) -> Freedoms {
    let (mut sum, mut k) = (Freedoms::NONE, 0);
    while k < Freedoms::SINGLE.len() {
        if own.contains(Freedoms::SINGLE[k]) {
            sum = sum.union(OF_PARTS[part][k]);
        }
        k += 1;
    }
    sum
}

/// What freedoms of a member are in a part of it.
///
/// ```
/// use mstmm_plan::{Freedoms, freedoms_in_part};
/// assert_eq!(freedoms_in_part(2, Freedoms::SPACE), Freedoms::RZ);
/// ```
pub const fn freedoms_in_part(part: usize, of_member: Freedoms) -> Freedoms {
    let (mut sum, mut k) = (Freedoms::NONE, 0);
    while k < Freedoms::SINGLE.len() {
        let of = OF_PARTS[part][k];
        if !of.is_empty() && of_member.contains(of) {
            sum = sum.union(Freedoms::SINGLE[k]);
        }
        k += 1;
    }
    sum
}

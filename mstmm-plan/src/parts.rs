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

/// The stiffnesses and dampings of a hinge in space: the name, the part that has it, and its name in that part.
pub const HINGE_PARTS: [(&str, usize, &str); 12] = [
    ("stiffness_x", 0, "stiffness_x"),
    ("stiffness_y", 0, "stiffness_y"),
    ("stiffness_rz", 0, "stiffness_rz"),
    ("stiffness_z", 1, "stiffness_y"),
    ("stiffness_ry", 1, "stiffness_rz"),
    ("stiffness_rx", 2, "stiffness_rz"),
    ("damping_x", 0, "damping_x"),
    ("damping_y", 0, "damping_y"),
    ("damping_rz", 0, "damping_rz"),
    ("damping_z", 1, "damping_y"),
    ("damping_ry", 1, "damping_rz"),
    ("damping_rx", 2, "damping_rz"),
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

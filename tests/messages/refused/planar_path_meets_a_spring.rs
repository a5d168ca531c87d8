use mstmm::prelude::*;

system! {
    struct Mixed { k: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2;
//                                        ^^^^^^ join all planar elements here, or none
    fixed -> hinge 3 { stiffness_x: k, stiffness_y: k, stiffness_rz: k } -> conn 2 -> pinned;
}

fn main() {}

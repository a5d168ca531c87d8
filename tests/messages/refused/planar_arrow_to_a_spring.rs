use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> hinge 2 { stiffness_x: k, stiffness_y: k, stiffness_rz: m } -> free;
//                                     ^^ use planar elements on both sides of this arrow, or on none
}

fn main() {}

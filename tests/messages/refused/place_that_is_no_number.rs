use mstmm::prelude::*;

system! {
    struct Bar { length: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> free at (length, "here");
//                          ^^^^^^ expected `f64`, found `&str`
}

fn main() {}

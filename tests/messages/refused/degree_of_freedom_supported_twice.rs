use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> beam 1 { length: 1.0, bending_stiffness: k, mass_per_length: m } -> conn 2
//                                                                               ^^^^^^ one of them is enough
          -> beam 3 { length: 1.0, bending_stiffness: k, mass_per_length: m } -> free;
    pinned -> conn 2 <- fixed;
}

fn main() {}

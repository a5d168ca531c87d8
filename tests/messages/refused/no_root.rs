use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    conn 1 -> spring 2 { stiffness: k } -> mass 3 { mass: m } -> conn 1;
//  ^^^^^^ turn one of them to a support
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k, stiffness: m } -> free;
//                                    ^^^^^^^^^ remove one of the two
}

fn main() {}

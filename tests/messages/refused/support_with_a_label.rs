use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed 1 -> spring 2 { stiffness: k } -> mass 3 { mass: m } -> free;
//  ^^^^^ write `fixed` alone
}

fn main() {}

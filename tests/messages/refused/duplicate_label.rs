use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 1 { mass: m } -> free;
//                                             ^ elements share one set of labels, and an element is written once
}

fn main() {}

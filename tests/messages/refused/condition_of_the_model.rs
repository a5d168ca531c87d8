use mstmm::prelude::*;

system! {
    #[cfg(unix)]
//  ^^^^^^^^^^^^ it is about the whole model
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
    pinned;
//  ^^^^^^ join it to an element or a connection by an arrow
}

fn main() {}

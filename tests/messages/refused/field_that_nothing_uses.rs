#![deny(warnings)]

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }
//                         ^ no parameter uses `m`

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> free;
}

fn main() {}

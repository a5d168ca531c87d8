use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness } -> mass 2 { mass: m } -> free;
    let stiffness = 2.0 * k;
//  ^^^ move this one up
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, m: f64 }

    pinned -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
//  ^^^^^^ a translation path ends in `fixed` or `free` only
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Oscillator { stiffness: f64, m: f64 }

    let softer = 0.5 * stifness;

    fixed -> spring 1 { stiffness: softer } -> mass 2 { mass } -> free;
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Oscillator { mass: f64 }

    fixed -> spring 1 { stiffness: 2 } -> mass 2 { mass } -> free;
//                                 ^ use a float literal
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Oscillator { stiffness: f64, m: f64 }

    let softer = 0.5 * stifness;
//                     ^^^^^^^^ a local variable with a similar name exists

    fixed -> spring 1 { stiffness: softer } -> mass 2 { mass } -> free;
//                                                      ^^^^ not found in this scope
}

fn main() {}

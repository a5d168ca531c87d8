use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64, spans: usize }
//                                        ^^^^^ compute anything else in a `let` line

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {}

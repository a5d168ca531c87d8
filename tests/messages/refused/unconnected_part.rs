use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> free;
    fixed -> mass 2 { mass: m } -> free;
//                                 ^^^^ no path joins this part of the model to the first; a model is one tree
}

fn main() {}

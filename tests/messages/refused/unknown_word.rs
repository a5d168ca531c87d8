use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> rope 1 { stiffness: k } -> mass 2 { mass: m } -> free;
//           ^^^^ or a type of your own by a path with `::`
}

fn main() {}

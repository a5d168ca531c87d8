use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> sprin 1 { stiffness: k } -> mass 2 { mass: m } -> free;
//           ^^^^^ did you mean `spring`?
}

fn main() {}

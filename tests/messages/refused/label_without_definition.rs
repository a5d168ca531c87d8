use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring arm -> mass 2 { mass: m } -> free;
//           ^^^^^^^^^^ `spring arm` lacks its parameters in braces
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> mass 3 { mass: m } -> conn 4 -> free;
    conn 2 -> spring 5 { stiffness: k } -> conn 4;
//         ^^ a model without places is a tree of paths; cut the loop open, or give its connections and supports places, `at (x, y)`
}

fn main() {}

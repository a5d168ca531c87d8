use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    conn 1 -> spring 2 { stiffness: k } -> mass 3 { mass: m } -> free;
//  ^^^^^^ let paths end in it
}

fn main() {}

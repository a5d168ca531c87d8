use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> mass 3 { mass: m } -> free;
    fixed -> conn 4 <- free;
//           ^^^^^^ let the path of an element end in it
    conn 4 -> conn 2;
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
    fixed -> spring 3 { stiffness: k } -> mass 2;
//                                        ^^^^^^ an element is written once; let paths meet in a connection, `conn`
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> beam 2 { length: 1.0, bending_stiffness: k, mass_per_length: m } -> free;
//                                     ^^ put a connection with a free tip between these two elements
}

fn main() {}

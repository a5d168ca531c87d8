use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> conn 2 -> mass 3 { mass: m } -> free;
//                                               ^^ lead this arrow on to an element or to the root
}

fn main() {}

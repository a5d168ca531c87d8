use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> fixed;
    free -> mass 3 { mass: m } -> conn 2 -> free;
//                                       ^^ turn the arrows of one of the two paths round
}

fn main() {}

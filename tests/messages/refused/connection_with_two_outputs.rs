use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> mass 3 { mass: m } -> free;
    conn 2 -> fixed;
//         ^^ turn the arrows of one of the two paths round
}

fn main() {}

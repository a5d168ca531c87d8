use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k + m } <- fixed;
//                                         ^^ turn one of them round
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    free <- spring 1 { stiffness: k + m } -> free;
//                                        ^^ turn the arrows of one of the two paths round
}

fn main() {}

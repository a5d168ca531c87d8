use mstmm::prelude::*;

system! {
    struct Model { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m };
//                                        ^^^^^^ end its path with a support or a connection
}

fn main() {}

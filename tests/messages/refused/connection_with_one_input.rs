use mstmm::prelude::*;

system! {
    struct OneInput { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2 -> mass 3 { mass: m } -> free;
//                                        ^^^^^^ must lead on to fewer states, as from a beam to a spring
}

fn main() {}

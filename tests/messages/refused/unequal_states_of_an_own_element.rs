use mstmm::prelude::*;

system! {
    struct SprungBeam { length: f64, ei: f64, m: f64, k: f64 }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> mstmm::elements::Spring 2 { stiffness: k } -> fixed;
//                                                                        ^^ where the path goes on with fewer states
}

fn main() {}

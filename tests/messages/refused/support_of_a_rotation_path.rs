use mstmm::prelude::*;

system! {
    struct Shaft { k: f64, j: f64 }

    fixed -> torsion_spring 1 { stiffness: k } -> inertia 2 { inertia: j } -> guided;
//                                                                            ^^^^^^ a rotation path ends in `fixed` or `free` only
}

fn main() {}

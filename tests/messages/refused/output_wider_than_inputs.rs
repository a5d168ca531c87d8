use mstmm::prelude::*;

system! {
    struct Wider { k: f64, m: f64, j: f64 }

    fixed -> spring 1 { stiffness: k } -> conn 2;
//                                        ^^^^^^ give it a free tip, `free -> conn ..`
    fixed -> spring 3 { stiffness: k } -> conn 2 -> point_mass 4 { mass: m, inertia: j } -> free;
}

fn main() {}

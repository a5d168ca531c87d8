use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0);
    conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- pinned;
//                                                             ^^^^^^ its one motion is held by `fixed`, or `free`
    conn a <- along (0.0, 1.0) <- spring 3 { stiffness: l } <- conn u <- held(x);
//                                                                       ^^^^ its one motion is held by `fixed`, or `free`
}

fn main() {}

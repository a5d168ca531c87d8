use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> conn a -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//        ^^ write `at` behind `conn a` alone
        -> conn b at (l, 0.0) <- pinned at (l, 0.0);
//                                      ^^ write `at` behind `conn b` alone
}

fn main() {}

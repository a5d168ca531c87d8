use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0);
//                ^^ the place of `conn a` is said here first
    conn a at (l, 0.0) -> spring 2 { stiffness: l } -> conn b at (l, l) <- fixed;
//         ^^ `at` stands at one mention of a point, so remove this one
}

fn main() {}

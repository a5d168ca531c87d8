use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0) <- roller;
    conn a <- held(rz);
//            ^^^^ one support says all that is held, such as `held(x, rz)`
    fixed -> pinned;
//        ^^ put an element between them
}

fn main() {}

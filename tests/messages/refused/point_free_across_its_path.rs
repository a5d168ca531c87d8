use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0);
    conn a -> spring 2 { stiffness: l } -> conn b at (l, l);
//                                         ^^^^^^ remove its place, so that it moves along the path alone, or hold it by a support
    conn a -> spring 3 { stiffness: l } -> conn c at (2.0, l) <- free;
//                                         ^^^^^^ remove its place, so that it moves along the path alone, or hold it by a support
    conn a -> spring 4 { stiffness: l } -> free at (3.0, l);
//                                         ^^^^ remove its place, so that it moves along the path alone, or hold it by a support
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    held(x, y, z) at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//             ^ a point has `x`, `y` and `rz`
        -> conn c at (l, 0.0) <- held(x, y, x);
//                                          ^ remove one of the two
    conn c -> beam 4 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a;
    held() at (0.0, l) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a;
//  ^^^^ name its freedoms, or write `free`
    conn a at (l, l) -> spring 3 { stiffness: l } -> conn b at (l, 0.0);
    held(x, rz) along (1.0, 0.0) -> conn a;
//              ^^^^^ a skew support is `roller along (dx, dy)`
    held(x, rz) -> conn b;
//          ^^ remove it
}

fn main() {}

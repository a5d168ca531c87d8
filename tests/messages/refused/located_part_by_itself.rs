use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0);
    fixed at (0.0, l) -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                       ^^^^^^ a model is one structure, so name a connection of it here
        -> conn b at (l, l);
    conn c at (0.0, 2.0);
//  ^^^^^^ let the path of an element end in it
}

fn main() {}

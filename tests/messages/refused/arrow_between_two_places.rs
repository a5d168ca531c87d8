use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0) -> conn b at (l, l)
//                            ^^ put an element between them
        <- beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } <- fixed at (0.0, l);
}

fn main() {}

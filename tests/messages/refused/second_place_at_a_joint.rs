use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0) -> pin 2 {} -> conn b at (l, 0.0)
//                                                  ^^ remove this `at`
        -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> fixed at (l, l);
}

fn main() {}

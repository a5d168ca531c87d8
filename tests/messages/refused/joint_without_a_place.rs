use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> pin 2 {} -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//         ^^^^^ put a connection beside it, `-> conn a at (x, y) -> pin 2`
        -> point_mass 4 { mass: l } -> beam 5
//         ^^^^^^^^^^^^ put a connection beside it, `-> conn a at (x, y) -> point_mass 4`
        { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> fixed at (l, l);
}

fn main() {}

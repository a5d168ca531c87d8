use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at l -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                   ^ all points of a model have equally many
        -> fixed at (l, l, l);
//                  ^^^^^^^^^ all points of a model have equally many
}

fn main() {}

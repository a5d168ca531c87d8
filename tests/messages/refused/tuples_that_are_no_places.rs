use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0,) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//           ^^^^^^ a point of the plane has two, `at (x, y)`, and one coordinate is written without
        -> conn a at (l, 0.0, 0.0, l) -> beam 2
//                   ^^^^^^^^^^^^^^^^ a point of the plane has two, `at (x, y)`, and one coordinate is written without
        { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> fixed at ();
//                  ^^ a point of the plane has two, `at (x, y)`, and one coordinate is written without
}

fn main() {}

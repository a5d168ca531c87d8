use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0,) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//           ^^^^^^ is no place: a point has two coordinates, `at (x, y)`, or three
        -> conn a at (l, 0.0, 0.0, l) -> beam 2
//                   ^^^^^^^^^^^^^^^^ is no place: a point has two coordinates, `at (x, y)`, or three
        { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> fixed at ();
//                  ^^ is no place: a point has two coordinates, `at (x, y)`, or three
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    roller at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
//  ^^^^^^ say which way: `roller normal (0.0, 0.0, 1.0)` holds one direction, `roller along (1.0, 0.0, 0.0)` leaves one
        -> beam 2 { ..steel } -> guided at (l, l, 0.0);
//                               ^^^^^^ say which way: `guided normal (0.0, 0.0, 1.0)` holds one direction, `guided along (1.0, 0.0, 0.0)` leaves one
}

fn main() {}

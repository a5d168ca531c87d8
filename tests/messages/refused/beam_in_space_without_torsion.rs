use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                              ^^^^^^ `beam 1` lacks `torsional_stiffness` and `polar_inertia_per_length`: a beam in space stretches, turns about it
        -> conn a at (l, 0.0, 0.0);
}

fn main() {}

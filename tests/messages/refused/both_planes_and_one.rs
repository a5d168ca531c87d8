use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, bending_stiffness_y: 2.0 * l } -> conn a at (l, 0.0, 0.0);
//                                                ^^^^^^^^^^^^^^^^^^^ `beam 1` gives `bending_stiffness` for both planes, and `bending_stiffness_y` for one: remove one of the two
}

fn main() {}

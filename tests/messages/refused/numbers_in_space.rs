use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, up: (1, 0.0, 0.0) } -> conn a at (l, 0.0, 0.0)
//                                                     ^ mismatched types
        -> revolute_joint 2 { axis: (1.0, width, 0.0) } -> beam 3 { ..steel } -> roller at (l, l, "l") normal (0.0, 0.0, 1);
//                                        ^^^^^ cannot find value `width` in this scope
//                                                                                                ^^^ mismatched types
//                                                                                                                       ^ mismatched types
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0) -> beam 1 { ..steel, up: (0.0, 0.0, 1.0) } -> conn a at (l, 0.0)
        -> ball_joint 2 {} -> beam 3 { ..steel } -> conn b at (l, l);
    conn b <- about (0.0, 0.0, 1.0) <- torsion_spring 4 { stiffness: l } <- fixed;
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel, up: (0.0, 1.0) } -> conn a at (l, 0.0, 0.0)
        -> rigid_body 2 { mass: l, inertia: l, centre: (l, 0.0) };
    conn a -> beam 3 { ..steel } -> conn b at (l, l);
    conn a <- along (1.0, 0.0) <- spring 4 { stiffness: l } <- fixed;
}

fn main() {}

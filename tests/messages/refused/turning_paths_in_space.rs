use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0);
    conn a <- torsion_spring 2 { stiffness: l } <- fixed;
//         ^^ a path that turns acts about an axis: `conn a <- about (0.0, 0.0, 1.0) <- ..`
    conn a <- along (0.0, 0.0, 1.0) <- torsion_spring 3 { stiffness: l } <- fixed;
//            ^^^^^ a path that turns acts about an axis: `conn a <- about (0.0, 0.0, 1.0) <- ..`
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
        -> body 2 { mass: l, inertia: l } -> conn b at (l, l, 0.0);
//         ^^^^ `body` has its points by offsets, which places replace: take `rigid_body`
    conn a -> lever 3 { length: l } -> conn c at (l, l, l);
//            ^^^^^ `lever` is `rigid_link` now: write `rigid_link 3 {}`
    conn a -> tapered_beam 4 { bending_stiffness: l, mass_per_length: l } -> conn d at (l, l, 2.0 * l);
//            ^^^^^^^^^^^^ `tapered_beam` bends in one plane: take `beam`
}

fn main() {}

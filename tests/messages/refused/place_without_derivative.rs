use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (table(l), 0.0) <- roller along (1.0, l as f32 as f64);
//                    ^^^^^ write the formula here, or mark `l` with `#[no_sensitivity]`
//                                                           ^^ write the formula without it, or mark `l` with `#[no_sensitivity]`
    conn a <- along (l % 2.0, 1.0) <- spring 2 { stiffness: l } <- fixed;
//                     ^ write the formula without it, or mark `l` with `#[no_sensitivity]`
    conn a -> rigid_body 3 { mass: l, inertia: l, centre: (table(l), 0.0) };
//                                                         ^^^^^ write the formula here, or mark `l` with `#[no_sensitivity]`
}

fn main() {}

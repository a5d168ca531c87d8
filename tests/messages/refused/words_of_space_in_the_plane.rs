use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
//                          ^^^^^^^^^^^^^^^^^^^ `beam 1` has no parameter `torsional_stiffness`: it has that in space alone, so remove it
//                                                                                            ^^^^^^^^^^^^^^^^^^^^^^^^ `beam 1` has no parameter `polar_inertia_per_length`: it has that in space alone, so remove it
    }
    fixed at (0.0, 0.0) -> beam 1 { ..steel, up: (0.0, 0.0, 1.0) } -> conn a at (l, 0.0)
//                                           ^^ `beam` has no parameter `up`: it has that in space alone, so remove it
        -> ball_joint 2 {} -> beam 3 { ..steel } -> conn b at (l, l);
//         ^^^^^^^^^^ `ball_joint` is a joint of space: take `pin`
    conn b <- about (0.0, 0.0, 1.0) <- torsion_spring 4 { stiffness: l } <- fixed;
//            ^^^^^ `about` needs three coordinates: a path that turns does so about z here, so remove it
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
//  ^^^^^ write `fixed at (x, y)`
    conn a -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn b;
//         ^^^^^^ write `conn b at (x, y)`
    conn b -> spring 3 { stiffness: l } -> conn c at (0.0, l) <- fixed;
    conn c -> rigid_body 4 { mass: l, inertia: l, centre: (l, l) } <- conn d;
//                                                                    ^^^^^^ write `conn d at (x, y)`
    conn d <- pinned;
}

fn main() {}

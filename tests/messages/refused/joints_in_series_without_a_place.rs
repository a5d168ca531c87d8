use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0) -> rigid_body 2 { mass: l, inertia: l, centre: (l, l) }
        -> pin 3 {} -> rigid_body 4 { mass: l, inertia: l, centre: (l, l) };
//         ^^^^^ put a connection beside it, `-> conn a at (x, y) -> pin 3`
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    section steel {
        axial_stiffness: l, torsional_stiffness: l, bending_stiffness: l, mass_per_length: l, polar_inertia_per_length: l,
    }
    fixed at (0.0, 0.0, 0.0) -> beam 1 { ..steel } -> conn a at (l, 0.0, 0.0)
        -> pin 2 {} -> beam 3 { ..steel } -> conn b at (l, l, 0.0)
//         ^^^ `pin` is a joint of the plane: take `revolute_joint { axis: (..) }` or `ball_joint {}`
        -> slider 4 { along: (1.0, 0.0, 0.0) } -> beam 5 { ..steel } -> fixed at (l, l, l);
//         ^^^^^^ `slider` is a joint of the plane: take `prismatic_joint { axis: (..) }`
}

fn main() {}

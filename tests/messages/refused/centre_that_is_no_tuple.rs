use mstmm::prelude::*;

system! {
    struct M { l: f64, centre: f64 }
    fixed at (0.0, 0.0) -> rigid_body 1 { mass: l, inertia: l, centre } -> conn a at (l, 0.0);
//                                                             ^^^^^^ (x, y)`
    conn a -> slider 2 { along: (1.0, 0.0, 0.0) } -> fixed;
//                              ^^^^^^^^^^^^^^^ (dx, dy)`
    conn a -> rigid_body 3 { mass: l, inertia: l, centre: l } -> conn b at (1.0, 1.0);
//                                                        ^ (x, y)`
}

fn main() {}

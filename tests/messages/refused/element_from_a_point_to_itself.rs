use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn a at (l, 0.0);
    conn a -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn b;
//            ^^^^^^ lead it from one point to another
    conn a -> pin 3 {} -> conn b;
    conn a -> slider 4 { along: (1.0, 0.0) } -> conn a;
//            ^^^^^^^^ give its other side a connection of its own
    conn a -> along (1.0, 0.0) -> spring 5 { stiffness: l } -> conn u -> spring 6 { stiffness: l } -> conn u;
//                                                                       ^^^^^^^^ lead it from one point to another
}

fn main() {}

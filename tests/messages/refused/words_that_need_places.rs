use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed -> beam 1 { length: l, axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> rigid_body 2 { } -> pin 3 { } -> roller along (1.0, 0.0);
//         ^^^^^^^^^^ say where they are, `conn a at (x, y)`
//                             ^^^ say where they are, `conn a at (x, y)`
//                                                 ^^^^^ say where they are, `conn a at (x, y)`
    free -> mass 6 { mass: l } -> conn 4 -> along (1.0, 0.0) -> spring 5 { stiffness: l }
//                                          ^^^^^ say where they are, `conn a at (x, y)`
        -> held(x);
//         ^^^^ say where they are, `conn a at (x, y)`
}

fn main() {}

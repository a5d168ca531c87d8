use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//      ^^ put a connection between them, `-> conn a at (x, y) ->`
        -> rigid_body 3 { mass: l, inertia: l, centre: (l, l) } -> spring 4 { stiffness: l } -> conn a at (l, l) <- fixed;
//      ^^ put a connection between them, `-> conn a at (x, y) ->`
//                                                              ^^ put a connection between them, `-> conn a at (x, y) ->`
}

fn main() {}

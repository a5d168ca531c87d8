use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        <- conn a at (l, 0.0) <- pin 2 {} -> conn b;
//      ^^ turn one of the arrows round
//                                        ^^ turn one of the arrows round
//                               ^^^^^ give its other side a connection of its own
    conn b -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l };
//            ^^^^^^ end its path with a support or a connection
    rigid_body 4 { mass: l, inertia: l, centre: (l, l) };
//  ^^^^^^^^^^^^ lead an arrow to it from a connection with a place
    conn b -> conn b;
//         ^^ lead this arrow on to an element
    conn c at (1.0, 1.0) <- pinned;
//  ^^^^^^ let the path of an element end in it
    pinned at (0.0, 1.0);
//  ^^^^^^ join it to an element or a connection by an arrow
    conn a -> pinned at (0.0, 1.0) -> conn b;
//            ^^^^^^ hold a point in between by a connection, `support -> conn ..`
//                   ^^ write `at` behind `conn a` alone
}

fn main() {}

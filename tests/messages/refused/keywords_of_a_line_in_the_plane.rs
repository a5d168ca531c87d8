use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0)
//                         ^^^^^^ in the plane a beam stretches, too
        -> body 2 { mass: l, inertia: l, output_x: l, centre_x: l } -> conn b at (l, l)
//         ^^^^ take `rigid_body`
        -> elastic_hinge 3 { stiffness_y: l, stiffness_theta: l } -> fixed;
//         ^^^^^^^^^^^^^ write `hinge 
    conn b -> planar_body 4 { } -> fixed;
//            ^^^^^^^^^^^ take `rigid_body`
    conn a -> spatial_beam 5 { } -> plnar_beam 7 { } -> pin8 -> conn b;
//            ^^^^^^^^^^^^ did you mean `beam`?
//                                  ^^^^^^^^^^ did you mean `beam`?
//                                                      ^^^^ put a space before the label, `pin 8`
}

fn main() {}

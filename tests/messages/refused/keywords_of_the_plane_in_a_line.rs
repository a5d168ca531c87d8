use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at 0.0 -> planar_beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at l
//                  ^^^^^^^^^^^ write `beam 
        -> planar_hinge 2 { stiffness_x: l, stiffness_y: l, stiffness_theta: l } -> fixed;
//         ^^^^^^^^^^^^ write `hinge 
}

fn main() {}

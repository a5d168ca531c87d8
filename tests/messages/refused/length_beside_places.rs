use mstmm::prelude::*;

system! {
    struct M { length: f64, ea: f64 }
    fixed at (0.0, 0.0) -> beam 1 { length, axial_stiffness: ea, bending_stiffness: ea, mass_per_length: ea }
//                                  ^^^^^^ remove it
        -> conn a at (length, 0.0) -> beam 2 { axial: ea, bending_stiffness: ea, mass_per_length: ea }
//                                             ^^^^^ did you mean `axial_stiffness`?
        -> conn b at (length, ea) -> point_mass 3 { inertia: ea } -> pin 4 -> fixed;
//                                   ^^^^^^^^^^^^ `point_mass 3` lacks `mass`
//                                                                   ^^^^^ `pin 4` lacks its braces, `pin 4 {}`
}

fn main() {}

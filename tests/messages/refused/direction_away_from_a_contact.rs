use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> along (1.0, 0.0) -> beam 1
//                         ^^^^^ this arrow joins no such two, so remove it
        { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
    conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- along (1.0, 0.0) <- mass 3 { mass: l } <- free;
//                                                             ^^^^^ this arrow joins no such two, so remove it
    conn a <- along (1.0, 0.0) <- torsion_spring 4 { stiffness: l } <- fixed;
//            ^^^^^ remove `along`
    conn a <- along l <- spring 5 { stiffness: l } <- fixed;
//                  ^ a direction of the plane has two parts, `along (dx, dy)`
}

fn main() {}

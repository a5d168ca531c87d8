use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) along (1.0, 0.0) -> beam 1
//                      ^^^^^ remove `along`, which `roller` and `guided` take
        { axial_stiffness: l, bending_stiffness: l, mass_per_length: l } -> conn a at (l, 0.0);
    pinned along (1.0, 0.0) -> conn a;
//         ^^^^^ remove `along`, which `roller` and `guided` take
    roller at (0.0, l) along l -> beam 2 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                           ^ a direction of the plane has two parts, `along (dx, dy)`
        -> conn a -> beam 3 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> guided at (l, l) along (1.0, 0.0, 0.0);
//                                ^^^^^^^^^^^^^^^ a direction of the plane has two parts, `along (dx, dy)`
}

fn main() {}

use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
        -> conn 1 at (l, 0.0) -> beam 02 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                                    ^^ a label is a name or a decimal number without leading zero or suffix, such as `arm` or
        -> conn b at (l, l) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//                                  ^ elements share one set of labels, and an element is written once
        -> fixed at (0.0, l);
}

fn main() {}

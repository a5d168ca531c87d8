use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixd at (0.0, 0.0) -> beam 1 { axial_stiffness: l, bending_stiffness: l, mass_per_length: l }
//  ^^^^ did you mean `fixed`?
        -> wall at (l, 0.0);
//         ^^^^ the supports are `fixed`, `pinned`, `free`, `guided`, `roller` and `held`
}

fn main() {}

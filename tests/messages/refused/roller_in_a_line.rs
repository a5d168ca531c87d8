use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    held(x, y) at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l }
//       ^ a point has `y` and `rz`
        -> roller at l;
//         ^^^^^^ write `pinned`
}

fn main() {}

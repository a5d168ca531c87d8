use mstmm::prelude::*;

system! {
    struct M { l: f64 }
    fixed at 0.0 -> beam 1 { bending_stiffness: l, mass_per_length: l } -> conn a at l;
    conn a <- along (1.0, 0.0) <- spring 2 { stiffness: l } <- fixed;
//            ^^^^^ where points have one, paths act across the line, so remove it
}

fn main() {}

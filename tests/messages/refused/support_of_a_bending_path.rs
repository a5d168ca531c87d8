use mstmm::prelude::*;

system! {
    struct Cantilever { length: f64, ei: f64, m: f64 }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> roller;
//                                                                           ^^^^^^ a bending path ends in `fixed`, `pinned`, `free` or `guided`
}

fn main() {}

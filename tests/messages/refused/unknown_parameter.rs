use mstmm::prelude::*;

system! {
    struct Cantilever { length: f64, ei: f64, m: f64 }

    fixed -> beam 1 { lenght: length, bending_stiffness: ei, mass_per_length: m } -> free;
//                    ^^^^^^ did you mean `length`?
}

fn main() {}

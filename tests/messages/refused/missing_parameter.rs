use mstmm::prelude::*;

system! {
    struct Cantilever { length: f64, ei: f64, m: f64 }

    fixed -> beam 1 { length, mass_per_length: m } -> free;
//           ^^^^^^ `beam 1` lacks `bending_stiffness`
}

fn main() {}

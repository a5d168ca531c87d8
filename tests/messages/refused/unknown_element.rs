use mstmm::prelude::*;

system! {
    struct Cantilever { length: f64, ei: f64, m: f64 }

    fixed -> baem 1 { length, bending_stiffness: ei, mass_per_length: m } -> free;
//           ^^^^ did you mean `beam`?
}

fn main() {}

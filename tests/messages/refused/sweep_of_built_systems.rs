use mstmm::prelude::*;

system! {
    struct Mast { height: f64 }

    fixed -> beam 1 { length: height, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

fn main() {
    let built = [Mast { height: 1.0 }.build().unwrap()];
    let _ = built.iter().first_frequencies::<1>();
//                       ^^^^^^^^^^^^^^^^^ a sweep takes models with their parameters, or references to them, and builds each itself
}

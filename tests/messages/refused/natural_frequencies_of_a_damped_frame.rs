use mstmm::prelude::*;

system! {
    struct Bar { length: f64, damping: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> conn tip at (length, 0.0) -> damper 2 { damping } -> conn wall at (2.0 * length, 0.0) <- fixed;
}

fn main() {
    let system = Bar { length: 1.0, damping: 0.1 }.build().unwrap();
    system.first_frequencies::<1>().unwrap();
//         ^^^^^^^^^^^^^^^^^ search its `eigenvalues` instead of `natural_frequencies`
}

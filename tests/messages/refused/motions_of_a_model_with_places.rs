use mstmm::prelude::*;

system! {
    struct Bar { length: f64 }
    fixed at (0.0, 0.0) -> planar_beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> free at (length, 0.0);
}

fn main() {
    let system = Bar { length: 1.0 }.build().unwrap();
    let roots = system.first_frequencies::<1>().unwrap();
    let _ = system.mode_shape(&roots[0]);
//                 ^^^^^^^^^^ models with places have no motions yet
//                 ^^^^^^^^^^ planar elements have no motions yet
}

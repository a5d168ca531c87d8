use mstmm::prelude::*;

system! {
    struct Bar { length: f64 }
    fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
        -> free at (length, 0.0);
}

fn main() {
    let models = [1.0, 2.0].map(|length| Bar { length });
    let _ = models.iter().first_frequencies::<1>();
//                        ^^^^^^^^^^^^^^^^^ a model with places is built and searched by itself
}

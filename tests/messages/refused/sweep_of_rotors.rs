use mstmm::prelude::*;

system! {
    struct Rotor { speed: f64 }
    fixed -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, rotary_inertia: 1e-3, polar_inertia_per_length: 2e-3, speed,
    } -> free;
}

fn main() {
    let _ = [Rotor { speed: 1.0 }].into_iter().first_frequencies::<3>();
//                                             ^^^^^^^^^^^^^^^^^ whose whirls are searched
}

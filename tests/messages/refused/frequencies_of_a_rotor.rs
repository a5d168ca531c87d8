use mstmm::prelude::*;

system! {
    struct Rotor { speed: f64 }
    fixed -> beam 1 {
        length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0, rotary_inertia: 1e-3, polar_inertia_per_length: 2e-3, speed,
    } -> free;
}

fn main() {
    let rotor = Rotor { speed: 1.0 }.build().unwrap();
    let _ = rotor.first_frequencies::<3>();
//                ^^^^^^^^^^^^^^^^^ rotor.whirl(Whirl::Forward)
    let _ = rotor.first_eigenvalues::<3>();
//                ^^^^^^^^^^^^^^^^^ rotor.whirl(Whirl::Forward)
}

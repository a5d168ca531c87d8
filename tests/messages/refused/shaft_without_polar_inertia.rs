use mstmm::prelude::*;

system! {
    struct Rotor { speed: f64, k: f64 }
    section s { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }
    fixed -> beam 1 { ..s, rotary_inertia: k, speed } -> disk 2 { mass: k, inertia: k, polar_inertia: k, speed } -> conn a;
//                                            ^^^^^ lacks `polar_inertia_per_length`
//                                                       ^^^^ did you mean `disc`?
    fixed -> spring 3 { stiffness: k, stiffness_z: k } -> conn a;
//                                    ^^^^^^^^^^^ write `stiffness`
    conn a -> beam 4 { ..s, rotary_inertia: k, polar_inertia_per_length: k, speed, loss_factor: 0.1 } -> free;
//                                                                                 ^^^^^^^^^^^ name `kelvin_voigt_time`
}

fn main() {}

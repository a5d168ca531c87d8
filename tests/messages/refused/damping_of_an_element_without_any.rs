use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, eta: f64, m: f64 }

    fixed -> spring 1 { stiffness: k, external_damping: eta } -> mass 2 { mass: m, loss_factor: eta } -> free;
//                                    ^^^^^^^^^^^^^^^^ of damping it has `loss_factor` and `kelvin_voigt_time`
//                                                                                 ^^^^^^^^^^^ springs, torsion springs
}

fn main() {}

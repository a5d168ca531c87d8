use mstmm::prelude::*;

system! {
    struct OnPad { k: f64, eta: f64 }

    fixed -> beam 1 { length: 1.0, bending_stiffness: 2.0, mass_per_length: 3.0, loss_factor: eta } -> conn 2 -> free;
    conn 2 <- spring 3 { stiffness: k } <- fixed;
}

fn main() {
    let system = OnPad { k: 4.0, eta: 0.1 }.build().unwrap();
    let _ = system.natural_frequencies::<8>(0.0..=10.0);
//                 ^^^^^^^^^^^^^^^^^^^ search its `eigenvalues` instead of `natural_frequencies`, count them with `count_in`
}

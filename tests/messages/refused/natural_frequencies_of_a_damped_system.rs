use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, c: f64, m: f64 }

    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

fn main() {
    let system = Oscillator { k: 4.0, c: 0.1, m: 1.0 }.build().unwrap();
    let _ = system.natural_frequencies::<8>(0.0..=10.0);
//                 ^^^^^^^^^^^^^^^^^^^ search its `eigenvalues` instead of `natural_frequencies`, count them with `count_in`
    let _ = system.count_below(3.0);
//                 ^^^^^^^^^^^ search its `eigenvalues` instead of `natural_frequencies`, count them with `count_in`
}

use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {
    let system = Oscillator { k: 4.0, m: 1.0 }.build().unwrap();
    let _ = system.natural_frequencies::<4>(0.0..100.0);
//                                          ^^^^^^^^^^ write `0.0..=100.0`, not `0.0..100.0`
    let _ = system.frequencies_in(0.0..100.0);
//                                ^^^^^^^^^^ write `0.0..=100.0`, not `0.0..100.0`
}

use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, c: f64, m: f64 }

    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m } -> free;
}

fn main() {
    let system = Oscillator { k: 4.0, c: 0.1, m: 1.0 }.build().unwrap();
    let (load, entry) = (Oscillator::mass_2.output().force(), Oscillator::mass_2.output().deflection());
    let response = system.frequency_response(load, entry).unwrap();
    let _ = response.at(2.0);
//                      ^^^ pass `Complex::new(re, im)` for λ [1/s]
    let _ = system.mode_shape(&NaturalFrequency::default());
//          ^^^^^^ search its `eigenvalues` instead
}

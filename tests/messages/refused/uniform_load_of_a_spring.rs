use mstmm::prelude::*;

system! {
    struct Oscillator { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {
    let system = Oscillator { k: 1.0, m: 1.0 }.build().unwrap();
    let entry = Oscillator::mass_2.output().deflection();
    let _ = system.frequency_response(Oscillator::spring_1.uniform_load(), entry);
//                                                         ^^^^^^^^^^^^ carries no load along its length
}

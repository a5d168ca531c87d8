use mstmm::prelude::*;

system! {
    struct Cantilever { length: f64, ei: f64, m: f64 }

    fixed -> beam 1 { length, bending_stiffness: ei, mass_per_length: m } -> free;
}

system! {
    struct Oscillator { k: f64, m: f64 }

    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free;
}

fn main() {
    let system = Cantilever { length: 1.0, ei: 1.0, m: 1.0 }.build().unwrap();
    let root = system.first_frequencies::<1>().unwrap()[0];
    let shape = system.mode_shape(&root).unwrap();
    let _ = shape.state(Cantilever::beam_2.output());
//                                  ^^^^^^ there is an associated constant `beam_1`
    let _ = shape.state(Oscillator::mass_2.output());
//                      ^^^^^^^^^^^^^^^^^^^^^^^^^^^ expected `Point<Cantilever>`, found `Point<Oscillator>`
}

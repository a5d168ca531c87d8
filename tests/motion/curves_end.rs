//! Curves end, wherever resonances are.
#![allow(missing_docs, reason = "models of a test")]

use mstmm::prelude::*;
use mstmm::search::NaturalFrequency;

system! {
    /// Two equal spans with a damper between them, which every second mode does not move.
    struct Node { l: f64, ei: f64, m: f64, damping: f64 }
    pinned -> beam 1 { length: l, bending_stiffness: ei, mass_per_length: m } -> conn 2;
    conn 2 <- damper 3 { damping } <- fixed;
    conn 2 -> beam 4 { length: l, bending_stiffness: ei, mass_per_length: m } -> pinned;
}

system! {
    struct Oscillator { stiffness: f64, mass: f64 }
    fixed -> spring 1 { stiffness } -> mass 2 { mass } -> free;
}

/// A mode that rests at the damper has a decay of rounding size: its resonance is one of an undamped mode.
#[test]
fn at_modes_that_no_damper_moves() {
    let system = Node { l: 1.1, ei: 1.3, m: 0.7, damping: 0.3 }.build().unwrap();
    let roots = system.eigenvalues::<16>(Region { re: -300.0..=1.0, im: 0.1..=300.0 }).unwrap();
    let undamped = roots.iter().filter(|root| root.lambda.re.abs() <= root.error).count();
    assert!(undamped >= 3 && undamped < roots.len(), "{roots:?}");
    let (load, entry) = (Node::beam_1.input().torque(), Node::beam_4.output().rotation());
    let response = system.frequency_response(load, entry).unwrap();
    let curve = response.curve::<2000, _>(1.0..=300.0, &roots, 1e-2).unwrap();
    assert!(curve.windows(2).all(|pair| pair[0].omega < pair[1].omega));
}

/// In a range of a few frequencies that the arithmetic tells apart no gap is halved for ever.
#[test]
fn in_ranges_of_rounding_size() {
    let system = Oscillator { stiffness: 1.0, mass: 1.0 }.build().unwrap();
    let (load, entry) = (Oscillator::mass_2.input().force(), Oscillator::mass_2.input().deflection());
    let response = system.frequency_response(load, entry).unwrap();
    let none: [NaturalFrequency; 0] = [];
    for units in [1.0, 3.0, 50.0, 200.0] {
        let width = units * f64::EPSILON;
        let curve = response.curve::<500, _>(1.0 - width..=1.0 + width, &none, 1e-3).unwrap();
        // the resonance itself, at 1, is left out
        assert!(curve.len() >= 2 && curve.iter().all(|sample| sample.omega != 1.0), "{units}");
    }
    let single = Oscillator { stiffness: 1.0, mass: 1.0 }.build_as::<f32>().unwrap();
    let response = single.frequency_response(load, entry).unwrap();
    let none: [NaturalFrequency<f32>; 0] = [];
    assert!(response.curve::<500, _>(0.999_99..=1.000_01, &none, 1e-3).is_ok());
}

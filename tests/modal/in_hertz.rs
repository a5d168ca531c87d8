//! Frequencies in hertz, going in and coming out; errors as a program prints them.

use crate::models::{Cantilever, cantilever};
use mstmm::Complex;
use mstmm::frame::Frame;
use mstmm::prelude::*;

system! {
    /// A cantilever with a dashpot.
    struct Damped { length: f64 }
    fixed -> beam 1 { length, bending_stiffness: 180.0, mass_per_length: 2.5 } -> conn tip <- damper 2 { damping: 3.0 } <- fixed;
    conn tip -> free;
}

/// Trees, frames and sums over modes, damped or not: the same argument, and what `at` gives for it.
#[test]
fn responses_take_hertz() {
    let frequency = 7.25;
    let (omega, lambda) = (hertz(frequency), Complex::new(0.0, hertz(frequency)));
    assert_eq!(omega, std::f64::consts::TAU * frequency);

    let tree = Cantilever {}.build().unwrap();
    let response = tree.frequency_response(Cantilever::conn_tip.force(), Cantilever::conn_tip.deflection()).unwrap();
    let found = response.at_hertz(frequency).unwrap();
    assert_eq!(found, response.at(lambda).unwrap());
    assert!(found.im == 0.0 && (found.re - response.at(omega).unwrap()).abs() < 1e-14 * found.re.abs());

    let damped = Damped { length: 1.2 }.build().unwrap();
    let response = damped.frequency_response(Damped::conn_tip.force(), Damped::conn_tip.deflection()).unwrap();
    assert_eq!(response.at_hertz(frequency).unwrap(), response.at(lambda).unwrap());

    let (frame, [_, tip], _) = cantilever();
    let (load, entry) = (tip.force_y(), tip.displacement_y());
    let response = frame.frequency_response(load, entry).unwrap();
    assert_eq!(response.at_hertz(frequency).unwrap(), response.at(lambda).unwrap());
    let roots = frame.frequencies(3).unwrap();
    let modal = frame.modal_response::<3, _>(&roots, load, entry).unwrap();
    assert_eq!(modal.at_hertz(frequency).unwrap().re, modal.at(omega).unwrap());
    let modal = modal.with_damping_ratio(0.02).unwrap();
    assert_eq!(modal.at_hertz(frequency).unwrap(), modal.at(lambda).unwrap());
    assert!(modal.at_hertz(f64::NAN).is_err() && response.at_hertz(f64::INFINITY).is_err());
}

#[test]
fn a_frequency_prints_both_units() {
    let roots = Cantilever {}.build().unwrap().frequencies(2).unwrap();
    for root in &roots {
        assert_eq!(root.to_string(), format!("{} rad/s, {} Hz", root.omega, root.omega / std::f64::consts::TAU));
    }
    let range = hertz(0.1)..=roots[1].omega * (1.0 + 1e-12);
    assert_eq!(Cantilever {}.build().unwrap().frequencies_in(range).unwrap().len(), 2);
}

/// What `main` prints of an error is its sentence.
#[test]
fn errors_are_printed_as_their_text() {
    let wrong = Damped { length: -2.0 }.build().unwrap_err();
    assert_eq!(format!("{wrong:?}"), "beam 1: length is -2, but must be positive and finite");
    let mut none = Frame::new();
    none.point([0.0, 0.0]);
    let wrong = none.build().unwrap_err();
    assert_eq!(format!("{wrong:?}"), wrong.to_string());
    let tree = Cantilever {}.build().unwrap();
    let wrong = tree.frequencies_in(3.0..=2.0).unwrap_err();
    assert_eq!(format!("{wrong:?}"), wrong.to_string());
    let boxed: Box<dyn std::error::Error> = Box::new(wrong);
    assert_eq!(format!("{boxed:?}"), wrong.to_string());
}

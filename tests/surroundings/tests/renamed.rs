//! mstmm renamed in Cargo.toml.

use vibrations::prelude::*;

vibrations::system! {
    struct Oscillator { k: f64, m: f64 }
    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free
}

/// The built system has a name, so that a struct can hold it.
struct Controller {
    plant: OscillatorSystem,
}

/// Closed form: `ω = sqrt(9/1)`.
#[test]
fn a_renamed_crate_does_not_matter() {
    let controller = Controller { plant: Oscillator { k: 9.0, m: 1.0 }.build().unwrap() };
    assert_eq!(controller.plant.characteristic(3.0).value(), 0.0);
    let found = controller.plant.first_frequencies::<1>().unwrap();
    assert!((found[0].omega - 3.0).abs() <= 8.0 * f64::EPSILON, "{}", found[0]);
}

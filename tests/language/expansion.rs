//! The kept code of models (`mstmm-language/tests/expansion.rs`) compiles, and is what the macro stands for: the same numbers.

use mstmm::prelude::*;

#[path = "../../mstmm-language/tests/expansion/model.rs"]
pub mod model;

/// The emitted code; warnings in it would reach no user, since it comes from a macro of another crate.
#[rustfmt::skip]
#[allow(missing_docs, clippy::all)]
#[path = "../../mstmm-language/tests/expansion/expanded.rs"]
pub mod expanded;

#[path = "../../mstmm-language/tests/expansion/located_model.rs"]
pub mod located_model;

/// The emitted code of a model with places.
#[rustfmt::skip]
#[allow(missing_docs, clippy::all)]
#[path = "../../mstmm-language/tests/expansion/located_expanded.rs"]
pub mod located_expanded;

/// Δ and the determinant at complex λ, bit for bit.
#[test]
fn the_kept_code_gives_the_same_numbers() {
    let (stiffness, damping, mass) = (3.0, 0.4, 0.7);
    let of_macro = model::DampedMass { stiffness, damping, mass }.build().unwrap();
    let of_file = expanded::DampedMass { stiffness, damping, mass }.build().unwrap();
    for lambda in [Complex::new(0.0, 1.5), Complex::new(-3.0, 250.0), Complex::new(0.5, 9000.0)] {
        assert_eq!(of_file.characteristic(lambda), of_macro.characteristic(lambda), "at {lambda}");
        assert_eq!(of_file.overall_determinant(lambda), of_macro.overall_determinant(lambda), "at {lambda}");
    }
}

/// Δ at real and complex frequencies, bit for bit.
#[test]
fn the_kept_code_of_places_gives_the_same_numbers() {
    let (height, stiffness, lamp) = (3.0, 40.0, 1.5);
    let of_macro = located_model::Mast { height, stiffness, lamp }.build().unwrap();
    let of_file = located_expanded::Mast { height, stiffness, lamp }.build().unwrap();
    for omega in [0.3, 25.0, 9000.0] {
        assert_eq!(of_file.characteristic(omega), of_macro.characteristic(omega), "at {omega}");
        let lambda = Complex::new(-0.1, omega);
        assert_eq!(of_file.characteristic(lambda), of_macro.characteristic(lambda), "at {lambda}");
    }
}

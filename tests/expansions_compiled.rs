//! The kept code of the examples (see `expansions.rs`) compiles, and is what the macro stands for: the same numbers.

use mstmm::prelude::*;
use paper::models;

/// The emitted code; warnings in it would reach no user, since it comes from a macro of another crate.
#[rustfmt::skip]
#[allow(missing_docs, clippy::all)]
pub mod expansions {
    pub mod tip_body;
    pub mod restrained_beam;
    pub mod spring_and_mass;
    pub mod two_spans;
    pub mod damped_oscillator;
}

/// Builds the same model from the kept code and from the macro, and compares Δ and the determinant at complex λ bit for bit.
macro_rules! assert_same_system {
    ($file:ident :: $model:ident { $($field:ident),* }, $of_macro:expr) => {{
        let of_macro = $of_macro;
        let of_file = expansions::$file::$model { $($field: of_macro.$field),* };
        let (of_macro, of_file) = (of_macro.build().unwrap(), of_file.build().unwrap());
        for lambda in [Complex::new(0.0, 1.5), Complex::new(-3.0, 250.0), Complex::new(0.5, 9000.0)] {
            assert_eq!(of_file.characteristic(lambda), of_macro.characteristic(lambda), stringify!($model));
            assert_eq!(of_file.overall_determinant(lambda), of_macro.overall_determinant(lambda), stringify!($model));
        }
    }};
}

#[test]
fn the_kept_code_gives_the_same_numbers() {
    assert_same_system!(
        tip_body::TipBody { length, bending_stiffness, mass_per_length, mass, inertia, eccentricity, depth },
        models::light_tip_body()
    );
    assert_same_system!(
        restrained_beam::RestrainedBeam {
            length,
            bending_stiffness,
            mass_per_length,
            left_stiffness,
            left_torsion,
            right_stiffness,
            right_torsion
        },
        models::restrained_beam()
    );
    assert_same_system!(
        spring_and_mass::SpringAndMass {
            length,
            bending_stiffness,
            mass_per_length,
            spring_position,
            mass_position,
            stiffness,
            mass
        },
        models::spring_and_mass()
    );
    assert_same_system!(
        two_spans::TwoSpans {
            length,
            bending_stiffness,
            mass_per_length,
            support_position,
            spring_position,
            stiffness,
            mass
        },
        models::two_spans()
    );
    assert_same_system!(
        damped_oscillator::DampedOscillator {
            length,
            bending_stiffness,
            mass_per_length,
            spring_position,
            oscillator_position,
            torsion_position,
            spring_stiffness,
            oscillator_stiffness,
            damping,
            mass,
            torsion_stiffness
        },
        models::damped_oscillator()
    );
}

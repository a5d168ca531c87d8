//! Models that are right, and must not be refused for what stands around them.

use mstmm::prelude::*;

/// Types with the names of emitted constants and type parameters, used in the model and not.
mod named_like_internals {
    #![allow(dead_code)]

    pub(super) struct N;
    #[expect(clippy::upper_case_acronyms, reason = "it is the name that could clash")]
    pub(super) struct LAYOUT;
    pub(super) struct C;

    pub(super) struct T;
    impl T {
        pub(super) const STIFFNESS: f64 = 4.0;
    }

    #[allow(non_snake_case)]
    pub(super) mod S {
        pub(crate) use mstmm::elements::Mass;
    }

    mstmm::system! {
        #[derive(Debug)]
        pub(super) struct Oscillator { pub(super) mass: f64 }
        fixed -> spring 1 { stiffness: T::STIFFNESS } -> S::Mass 2 { mass } -> free
    }
}

#[test]
fn a_type_may_be_named_like_what_is_emitted() {
    let system = named_like_internals::Oscillator { mass: 1.0 }.build().unwrap();
    assert_eq!(named_like_internals::OscillatorSystem::N, 2);
    assert_eq!(system.overall_determinant(2.0).value(), 0.0);
    assert_eq!(system.characteristic(2.0).value(), 0.0);
}

/// Names of what is emitted for places, in a formula.
mod named_like_a_sketch {
    #[expect(clippy::upper_case_acronyms, reason = "it is the name that could clash")]
    pub(super) struct SKETCH;
    impl SKETCH {
        pub(super) const WIDTH: f64 = 2.0;
    }
    pub(super) const ORDER: f64 = 3.0;

    mstmm::system! {
        pub(super) struct Skeleton { pub(super) number: f64 }
        fixed at (0.0, 0.0) -> beam 1 { axial_stiffness: 1e3, bending_stiffness: ORDER, mass_per_length: number }
            -> free at (SKETCH::WIDTH, 0.0)
    }
}

#[test]
fn a_place_may_be_named_like_what_is_emitted() {
    let system = named_like_a_sketch::Skeleton { number: 1.0 }.build().unwrap();
    // a cantilever: (βl)² = 3.516015 of the first mode
    let first = 3.516_015_268_5 * (3.0_f64 / 16.0).sqrt();
    assert!((system.first_frequencies::<1>().unwrap()[0].omega - first).abs() < 1e-9);
}

system! {
    struct Configured {
        #[cfg(test)]
        stiffness: f64,
        #[cfg(not(test))]
        stiffness: f64,
        #[cfg(any())]
        absent: f64,
        mass: f64,
    }
    fixed -> spring 1 { stiffness } -> mass 2 { mass } -> free
}

#[test]
fn a_field_may_depend_on_the_configuration() {
    let system = Configured { stiffness: 9.0, mass: 1.0 }.build().unwrap();
    assert_eq!(system.overall_determinant(3.0).value(), 0.0);
}

/// A mass on as many springs as there are labels.
macro_rules! star {
    ($($label:tt)*) => {
        system! {
            struct Star { k: f64, m: f64 }
            free -> mass hub { mass: m } -> conn centre -> free;
            $(fixed -> spring $label { stiffness: k } -> conn centre;)*
        }
    };
}
star!(
    0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19
    20 21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39
    40 41 42 43 44 45 46 47 48 49 50 51 52 53 54 55 56 57 58 59
    60 61 62 63 64 65 66 67 68 69 70 71 72 73 74 75 76 77 78 79
    80 81 82 83 84 85 86 87 88 89 90 91 92 93 94 95 96 97 98 99
);

/// Closed form: a hundred springs on one mass.
#[test]
fn a_hundred_paths_meet_at_one_connection() {
    let system = Star { k: 0.04, m: 1.0 }.build().unwrap();
    assert_eq!(StarSystem::N, 102);
    let found = system.first_frequencies::<1>().unwrap();
    assert!((found[0].omega - 2.0).abs() <= 8.0 * f64::EPSILON, "{}", found[0]);
}

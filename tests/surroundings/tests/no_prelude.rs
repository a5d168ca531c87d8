//! A model in a crate without any prelude: emitted code names all that it uses by its full path.
#![no_implicit_prelude]

use ::core::assert_eq;
use ::vibrations::search::Characteristic as _;

mod model {
    ::vibrations::system! {
        #[derive(::core::clone::Clone, ::core::fmt::Debug)]
        pub(super) struct Beams { pub(super) length: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) k: f64 }
        let half = 0.5 * length;
        pinned -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m } -> conn 2
               -> beam 3 { length: half, bending_stiffness: ei, mass_per_length: m } -> pinned;
        conn 2 <- spring 4 { stiffness: k } <- fixed;
        conn 2 <- mass 5 { mass: m } <- free
    }
}

mod with_prelude {
    use ::std::prelude::rust_2024::*;

    ::vibrations::system! {
        #[derive(Clone, Debug)]
        pub(super) struct Beams { pub(super) length: f64, pub(super) ei: f64, pub(super) m: f64, pub(super) k: f64 }
        let half = 0.5 * length;
        pinned -> beam 1 { length: half, bending_stiffness: ei, mass_per_length: m } -> conn 2
               -> beam 3 { length: half, bending_stiffness: ei, mass_per_length: m } -> pinned;
        conn 2 <- spring 4 { stiffness: k } <- fixed;
        conn 2 <- mass 5 { mass: m } <- free
    }
}

/// Oracle: the same model where everything is in scope.
#[test]
fn no_prelude_is_needed() {
    use ::core::result::Result;
    let (length, ei, m, k) = (2.0, 3.0, 0.7, 11.0);
    let system = Result::unwrap(model::Beams { length, ei, m, k }.build());
    let expected = Result::unwrap(with_prelude::Beams { length, ei, m, k }.build());
    assert_eq!(model::BeamsSystem::N, 6);
    for omega in [0.5, 2.0, 40.0] {
        assert_eq!(system.characteristic(omega), expected.characteristic(omega));
    }
}

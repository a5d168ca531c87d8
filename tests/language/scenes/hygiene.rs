//! Names and scopes around a model that must not matter to it. Each model is a spring and a mass, `ω = sqrt(k/m)`.

use super::{ROUNDING, assert_frequencies};
use mstmm::prelude::*;

system! {
    /// Fields and labels with the names of emitted variables, fields and generics.
    #[derive(Clone, Copy, Debug)]
    struct NamedLikeInternals {
        system: f64, x: f64, n: f64, element_1: f64, equation: f64, determinant: f64, u_1: f64, u_x: f64, layout: f64,
    }
    let value = system + x + n + element_1;
    fixed -> spring x { stiffness: value } -> mass system { mass: equation } -> conn determinant;
    fixed -> spring 1 { stiffness: determinant } -> conn determinant;
    fixed -> spring element_1 { stiffness: u_1 } -> conn determinant;
    fixed -> spring S { stiffness: u_x } -> conn determinant;
    fixed -> spring T { stiffness: layout } -> conn determinant -> free;
}

/// Closed form: `ω = sqrt((1+2+3+4 + 1 + 1.5 + 2 + 3.5)/0.5) = 6`.
#[test]
fn a_field_or_a_label_may_be_named_like_an_internal() {
    let model = NamedLikeInternals {
        system: 1.0,
        x: 2.0,
        n: 3.0,
        element_1: 4.0,
        equation: 0.5,
        determinant: 1.0,
        u_1: 1.5,
        u_x: 2.0,
        layout: 3.5,
    };
    let system = model.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[6.0], ROUNDING);
}

const N: f64 = 4.0;
const LAYOUT: [f64; 2] = [0.25, 1.0];

system! {
    struct UsesConstants { scale: f64 }
    let k = N * LAYOUT[1] * scale;
    fixed -> spring 1 { stiffness: k } -> mass 2 { mass: LAYOUT[0] * N } -> free
}

/// Closed form: `ω = sqrt(4/1)`.
#[test]
fn constants_of_the_user_keep_their_meaning_in_parameters() {
    let system = UsesConstants { scale: 1.0 }.build().unwrap();
    assert_eq!(UsesConstantsSystem::N, 2);
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0], ROUNDING);
}

/// Closed form: `ω = sqrt(18/2)`.
#[test]
fn a_model_may_stand_in_a_function() {
    const SQUARE: f64 = 9.0;
    fn twice(x: f64) -> f64 {
        2.0 * x
    }
    system! {
        struct Local { #[no_sensitivity] m: f64 }
        fixed -> spring 1 { stiffness: twice(SQUARE) } -> mass 2 { mass: twice(m) } -> free
    }
    let system = Local { m: 1.0 }.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[3.0], ROUNDING);
}

/// A scope in which the names of the prelude mean something else, and the facade has another name.
mod shadows {
    #![allow(dead_code, unused_imports)]

    /// As traits and as derives.
    pub(super) use ::core::hash::{Hash as Clone, Hash as Debug};
    pub(super) use ::mstmm as vibrations;

    pub(super) mod core {}
    pub(super) mod std {}
    pub(super) mod mstmm {}
    pub(super) mod mstmm_core {}
    pub(super) struct Result;
    pub(super) struct Option;
    pub(super) struct Vec;
    pub(super) struct Some;
    pub(super) struct None;
    pub(super) struct Ok;
    pub(super) struct Err;
    pub(super) struct Complex;
    pub(super) struct SMatrix;
    pub(super) struct Spring;
    pub(super) struct Mass;
    pub(super) struct T;
    pub(super) struct S;
    pub(super) trait Evaluate {}

    vibrations::system! {
        pub(super) struct Shadowed { pub(super) k: f64 }
        fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> free
    }
}

/// Closed form: `ω = sqrt(25/1)`.
#[test]
fn shadowed_names_and_a_renamed_crate_do_not_matter() {
    let system = shadows::Shadowed { k: 25.0 }.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[5.0], ROUNDING);
}

/// Passes every kind of fragment on.
macro_rules! oscillator {
    (
        $(#[$attribute:meta])*
        $visibility:vis $model:ident, $field:ident, $label:literal, $name:tt, $root:ident, $e:expr
    ) => {
        system! {
            $(#[$attribute])*
            $visibility struct $model { $field: f64 }
            let mass = $e / 2.0;
            fixed -> spring $label { stiffness: $e * 2.0 } -> mass $name { mass: $field * mass } -> $root
        }
    };
}
oscillator!(#[doc = "Spring and mass."] pub(crate) FromFragments, m, 1, block, free, 1.0 + 1.0);

/// Closed form with a stiffness of `(1 + 1) · 2 = 4`, not `1 + 1 · 2 = 3`, on a mass of `(1 + 1)/2 = 1`, not `1 + 1/2`.
#[test]
fn an_expression_passed_by_a_macro_keeps_its_value() {
    let system = FromFragments { m: 1.0 }.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0], ROUNDING);
}

/// One spring with an expression from outside, another with what look like the same tokens.
macro_rules! two_springs {
    ($model:ident, $e:expr) => {
        system! {
            struct $model { m: f64 }
            fixed -> spring 1 { stiffness: $e * 2.0 } -> mass 2 { mass: m } -> conn 4 -> free;
            fixed -> spring 3 { stiffness: 1.0 + 1.0 * 2.0 } -> conn 4
        }
    };
}
two_springs!(EqualTokensInAGroup, 1.0 + 1.0);

/// Closed form with a stiffness of `(1 + 1) · 2 + 1 + 1 · 2 = 7` on a mass of 7/4.
#[test]
fn the_same_tokens_in_another_grouping_are_another_element() {
    let system = EqualTokensInAGroup { m: 1.75 }.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0], ROUNDING);
}

/// A `let` of the macro and one of its caller have the same name and different meaning, as everywhere in Rust.
macro_rules! hygienic {
    ($model:ident, $field:ident, $own:ident, $e:expr) => {
        system! {
            struct $model { $field: f64 }
            let $own = 4.0 * $field;
            let k = 9.0 * $field;
            fixed -> spring 1 { stiffness: k } -> mass 2 { mass: 1.0 } -> conn 4 -> free;
            fixed -> spring 3 { stiffness: $e } -> conn 4
        }
    };
}
hygienic!(Hygienic, unit, k, k);

/// Closed form with a stiffness of `9 + 4 = 13`: the spring of the macro has 9, that of the caller 4.
#[test]
fn equal_names_of_a_macro_and_its_caller_are_two_variables() {
    let system = Hygienic { unit: 1.0 }.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[13.0_f64.sqrt()], ROUNDING);
}

/// A function whose own type parameters have the names of emitted ones.
fn frequency_of<T: Into<f64>, S: Into<f64>>(stiffness: T, mass: S) -> Option<f64> {
    system! {
        struct Local { k: f64, m: f64 }
        fixed -> spring 1 { stiffness: k } -> mass 2 { mass: m } -> free
    }
    let system = Local { k: stiffness.into(), m: mass.into() }.build().ok()?;
    Some(system.first_frequencies::<1>().ok()?[0].omega)
}

/// Closed form: `ω = sqrt(16/1)`, for whatever types.
#[test]
fn a_model_may_stand_in_a_generic_function() {
    for omega in [frequency_of(16.0_f64, 1.0_f32), frequency_of(16_u8, 1_i32)] {
        let omega = omega.unwrap();
        assert!((omega - 4.0).abs() <= 8.0 * f64::EPSILON, "{omega}");
    }
}

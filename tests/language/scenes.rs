//! The language of `system!`: every way of writing a scene gives the same matrix, and the matrix has the frequencies of
//! closed forms.

mod hygiene;

use crate::support::roots::{assert_same_roots, bisect, zeros};
use core::f64::consts::PI;
use mstmm::element::SMatrix;
use mstmm::number::Scaled;
use mstmm::prelude::*;

/// Closed form and determinant of a few springs and masses: a handful of roundings on either side.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// The zeros of a determinant up to ω = 10 are `expected`.
#[track_caller]
fn assert_frequencies(determinant: impl Fn(f64) -> Scaled<f64>, expected: &[f64], tolerance: f64) {
    assert_same_roots(&zeros(determinant, 0.0..=10.0, 400), expected, tolerance);
}

/// A pinned beam with a spring and a mass (section 4.3 of the paper), written with paths of one's own.
macro_rules! spring_and_mass {
    ($fields:tt $($model:ident { $($paths:tt)* })*) => {$(
        system! {
            #[derive(Clone, Copy, Debug)]
            struct $model $fields
            $($paths)*
        }

        impl $model {
            fn matrix() -> SMatrix<f64, 6, 6> {
                let model = $model { length: 0.4, ei: 1.3, m: 0.7, ky: 2.0, mass: 0.9 };
                model.build().unwrap().overall_matrix(3.0)
            }
        }
    )*};
}

spring_and_mass! {
    { length: f64, ei: f64, m: f64, ky: f64, mass: f64 }
    AlongTheBeam {
        pinned -> beam 1 { length: length, bending_stiffness: ei, mass_per_length: m }
               -> conn 2 -> beam 4 { length: length, bending_stiffness: ei, mass_per_length: m }
               -> conn 5 -> beam 7 { length: 2.0 * length, bending_stiffness: ei, mass_per_length: m } -> pinned;
        fixed -> spring 3 { stiffness: ky } -> conn 2;
        free -> mass 6 { mass: mass } -> conn 5;
    }
    Backwards {
        pinned <- beam 7 { length: 2.0 * length, bending_stiffness: ei, mass_per_length: m }
               <- conn 5 <- beam 4 { length: length, bending_stiffness: ei, mass_per_length: m }
               <- conn 2 <- beam 1 { length: length, bending_stiffness: ei, mass_per_length: m } <- pinned;
        conn 2 <- spring 3 { stiffness: ky } <- fixed;
        conn 5 <- mass 6 { mass: mass } <- free;
    }
    BranchesFirst {
        free -> mass 6 { mass: mass } -> conn 5;
        fixed -> spring 3 { stiffness: ky } -> conn 2;
        conn 5 -> beam 7 { length: 2.0 * length, bending_stiffness: ei, mass_per_length: m } -> pinned;
        conn 2 -> beam 4 { length: length, bending_stiffness: ei, mass_per_length: m } -> conn 5;
        conn 2 <- beam 1 { length: length, bending_stiffness: ei, mass_per_length: m } <- pinned;
    }
    ArrowsMeet {
        pinned -> beam 1 { length: length, bending_stiffness: ei, mass_per_length: m }
               -> conn 2 <- spring 3 { stiffness: ky } <- fixed;
        free -> mass 6 { mass: mass } -> conn 5 <- beam 4 { length: length, bending_stiffness: ei, mass_per_length: m }
             <- conn 2;
        conn 5 -> beam 7 { length: 2.0 * length, bending_stiffness: ei, mass_per_length: m } -> pinned;
    }
    NamesShorthandAndNoFinalSemicolon {
        pinned -> beam left { length, bending_stiffness: ei, mass_per_length: m }
               -> conn at_spring -> beam r#type { mass_per_length: m, length, bending_stiffness: ei, }
               -> conn at_mass -> beam right { length: 2.0 * length, bending_stiffness: ei, mass_per_length: m }
               -> pinned;
        fixed -> spring 0 { stiffness: ky } -> conn at_spring;
        free -> mass _1 { mass } -> conn at_mass
    }
    DerivedQuantities {
        let bending_stiffness = ei;
        let (length, rest): (f64, f64) = (length, length + length);
        let mass_per_length: f64 = { let density = 2.0 * m; density / 2.0 };
        pinned -> beam 1 { length, bending_stiffness, mass_per_length }
               -> conn 2 -> beam 4 { length, bending_stiffness, mass_per_length }
               -> conn 5 -> beam 7 { length: rest, bending_stiffness, mass_per_length } -> pinned;
        fixed -> spring 3 { stiffness: if ky < -ky { 0.0 } else { ky } } -> conn 2;
        free -> mass 6 { mass } -> conn 5;
    }
}

/// Oracle: the first way of writing, which `overall_matrix.rs` checks by hand; equal to the last bit.
#[test]
fn every_way_of_writing_a_scene_gives_the_same_matrix() {
    let expected = AlongTheBeam::matrix();
    assert_eq!(Backwards::matrix(), expected);
    assert_eq!(BranchesFirst::matrix(), expected);
    assert_eq!(ArrowsMeet::matrix(), expected);
    assert_eq!(NamesShorthandAndNoFinalSemicolon::matrix(), expected);
    assert_eq!(DerivedQuantities::matrix(), expected);
}

/// Two unequal beams that meet, in one order or the other.
macro_rules! two_arms {
    ($model:ident: $first:ident, $second:ident) => {
        system! {
            #[derive(Clone, Copy, Debug)]
            struct $model { $first: f64, $second: f64 }
            fixed -> beam $first { length: $first, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 1;
            fixed -> beam $second { length: $second, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 1;
            conn 1 -> free
        }
    };
}
two_arms!(ShortFirst: short, long);
two_arms!(LongFirst: long, short);

/// Oracle: eqs. (21)-(23), by which exchanging the inputs exchanges their columns and the sign of the geometrical
/// equations; and the static beam.
#[test]
fn among_equal_states_the_first_written_is_the_reference() {
    let short_first = ShortFirst { short: 0.5, long: 0.8 }.build().unwrap().overall_matrix(2.0);
    let long_first = LongFirst { short: 0.5, long: 0.8 }.build().unwrap().overall_matrix(2.0);
    const EXCHANGED: [usize; 6] = [2, 3, 0, 1, 4, 5];
    for column in 0..6 {
        // rows 0 and 1 hold the displacements of the reference: equal to those of the other input only in a solution
        for row in 2..6 {
            let sign = if row < 4 { 1.0 } else { -1.0 };
            assert_eq!(long_first[(row, column)], sign * short_first[(row, EXCHANGED[column])]);
        }
    }
    // at rest, a unit moment at the clamped end of the first beam deflects its other end by l²/2
    let at_rest = ShortFirst { short: 0.5, long: 0.8 }.build().unwrap().overall_matrix(0.0);
    assert_eq!((at_rest[(0, 0)], at_rest[(0, 2)]), (0.125, 0.0));
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct ThreeSprings { a: f64, b: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: a } -> conn 4 -> mass 5 { mass: m } -> free;
    fixed -> spring 2 { stiffness: b } -> conn 4 <- spring 3 { stiffness: c } <- fixed;
}

/// Closed form: `ω = sqrt((a + b + c)/m)`.
#[test]
fn three_inputs_meet_at_one_connection() {
    let system = ThreeSprings { a: 1.0, b: 2.5, c: 0.5, m: 0.25 }.build().unwrap();
    assert_eq!(ThreeSpringsSystem::N, 4);
    assert_frequencies(|omega| system.overall_determinant(omega), &[4.0], ROUNDING);
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct SupportAsInput { length: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2;
    pinned -> conn 2;
    conn 2 -> beam 3 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
}
system! {
    #[derive(Clone, Copy, Debug)]
    struct SupportAsRoot { length: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2;
    pinned -> beam 3 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2;
    conn 2 -> pinned;
}

/// Closed form: a beam over two equal spans vibrates like a pinned-pinned span, `sin z = 0`, or like a pinned-clamped
/// one, `tan z = tanh z`.
#[test]
fn a_support_stands_directly_at_a_connection_as_tip_or_as_root() {
    let pinned_clamped = |z: f64| z.sin() - z.cos() * z.tanh();
    let roots = [PI, bisect(pinned_clamped, PI, 1.5 * PI), 2.0 * PI, bisect(pinned_clamped, 2.0 * PI, 2.5 * PI)];
    let length = 3.0;
    let expected = roots.map(|z| (z / length).powi(2));
    // transfer over two spans loses e^{2z} of the digits
    let tolerance = f64::EPSILON * (2.0 * roots[3]).exp();
    let (tip, root) = (SupportAsInput { length }.build().unwrap(), SupportAsRoot { length }.build().unwrap());
    assert_eq!((SupportAsInputSystem::N, SupportAsRootSystem::N), (6, 6));
    for determinant in [&|x| tip.overall_determinant(x), &|x| root.overall_determinant(x)] as [&dyn Fn(f64) -> _; 2] {
        assert_same_roots(&zeros(determinant, 0.0..=7.0, 400), &expected, tolerance);
    }
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct TwoLinesIntoBending { k: f64, mass: f64, inertia: f64 }
    fixed -> spring 1 { stiffness: k } -> conn 4;
    fixed -> torsion_spring 2 { stiffness: k } -> conn 4;
    free -> conn 4 -> point_mass 5 { mass, inertia } -> free;
}
system! {
    #[derive(Clone, Copy, Debug)]
    struct OneLineIntoBending { k: f64, mass: f64 }
    fixed -> spring 1 { stiffness: k } -> conn 4;
    free -> conn 4 -> point_mass 5 { mass, inertia: 1.0 } -> guided;
}

/// Closed form: deflection and rotation do not couple, `ω = sqrt(k/m)` and `ω = sqrt(k/J)`.
#[test]
fn a_free_tip_widens_the_state_at_a_connection() {
    let system = TwoLinesIntoBending { k: 9.0, mass: 2.25, inertia: 1.0 }.build().unwrap();
    assert_eq!(TwoLinesIntoBendingSystem::N, 6);
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0, 3.0], ROUNDING);
    let system = OneLineIntoBending { k: 9.0, mass: 2.25 }.build().unwrap();
    assert_eq!(OneLineIntoBendingSystem::N, 5);
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0], ROUNDING);
}

system! {
    #[derive(Clone, Copy, Debug)]
    struct EqualElements { k: f64, c: f64, m: f64 }
    fixed -> spring 1 { stiffness: k, damping: c } -> mass 2 { mass: m }
          -> spring 3 { damping: c, stiffness: k } -> mass 4 { mass: m } -> free
}

/// Closed form: two equal masses on equal springs have `Δ = (mλ²)² + 3 κ mλ² + κ²` with κ = k + cλ, where the
/// denominator κ of each of the two dashpots counts.
#[test]
fn two_elements_with_the_same_parameters_are_two_elements() {
    let (k, c, m) = (2.0, 0.3, 1.5);
    let system = EqualElements { k, c, m }.build().unwrap();
    let lambda = Complex::new(-0.4, 1.1);
    let (a, kappa) = (lambda * lambda * m, lambda * c + k);
    let (expected, actual) = (a * a + a * kappa * 3.0 + kappa * kappa, system.overall_determinant(lambda).value());
    let terms = a.norm_sqr() + 3.0 * a.norm() * kappa.norm() + kappa.norm_sqr();
    assert!((actual - expected).norm() <= ROUNDING * terms, "{actual} instead of {expected}");
}

mod elsewhere {
    mstmm::system! {
        /// A model for others.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        #[must_use]
        pub(crate) struct Oscillator {
            /// Stiffness [N/m]
            pub(crate) stiffness: f64,
            #[doc = "Mass [kg]"]
            pub(crate) mass: f64,
        }
        fixed -> spring 1 { stiffness } -> mass 2 { mass } -> free;
    }
}

/// The derives exist, and the model, its fields, `build` and the system are visible as far as the struct says.
#[test]
fn attributes_derives_and_visibility_pass_through() {
    let model = elsewhere::Oscillator { stiffness: 9.0, mass: 1.0 };
    assert_eq!(model, model.clone());
    assert_eq!(format!("{model:?}"), "Oscillator { stiffness: 9.0, mass: 1.0 }");
    let system: elsewhere::OscillatorSystem = model.build().unwrap();
    let copy = system.clone();
    assert_frequencies(|omega| copy.overall_determinant(omega), &[3.0], ROUNDING);
    let wrong = elsewhere::Oscillator { stiffness: -1.0, ..elsewhere::Oscillator::default() };
    assert_eq!(wrong.build().unwrap_err().element, "spring 1");
}

system! {
    struct NoParameters;
    fixed -> torsion_spring 1 { stiffness: 4.0 } -> inertia 2 { inertia: 1.0 } -> free
}

/// Closed form: `ω = sqrt(k/J)`.
#[test]
fn a_model_needs_no_parameters() {
    let system = NoParameters.build().unwrap();
    assert_frequencies(|omega| system.overall_determinant(omega), &[2.0], ROUNDING);
}

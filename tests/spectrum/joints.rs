//! Beams with hinges of one freedom and levers: closed forms, determinants in double-double arithmetic, equivalent structures.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::hinged_models::{Gerber, Sliding};
use mstmm::number::{DoubleDouble, Scalar};
use mstmm::prelude::*;
use mstmm::search::{NaturalFrequency, SearchError};

system! {
    /// Cantilever with a crack.
    struct Cracked { from_clamp: f64, from_tip: f64, stiffness: f64 }
    fixed -> beam 1 { length: from_clamp, bending_stiffness: 1.0, mass_per_length: 1.0 }
          -> hinge 2 { stiffness_rz: stiffness }
          -> beam 3 { length: from_tip, bending_stiffness: 1.0, mass_per_length: 1.0 } -> free;
}

fn double(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

/// `sin z, cos z`, and `sinh z, cosh z` over cosh z.
fn waves(z: DoubleDouble) -> [DoubleDouble; 4] {
    let ((sin, cos), (sinh, cosh)) = (z.sin_cos(), z.sinh_cosh());
    [sin, cos, sinh / cosh, double(1.0) / cosh]
}

/// The first zeros z of a function, which changes its sign between steps of 0.02, as frequencies `z²`.
fn frequencies(count: usize, function: impl Fn(DoubleDouble) -> DoubleDouble) -> Vec<DoubleDouble> {
    let (is_positive, step) = (|z| function(z) > double(0.0), double(0.02));
    let (mut found, mut lower) = (Vec::new(), double(0.5));
    while found.len() < count {
        let upper = lower + step;
        if is_positive(lower) != is_positive(upper) {
            let [mut low, mut high] = [lower, upper];
            for _ in 0..100 {
                let middle = (low + high) * double(0.5);
                if is_positive(middle) == is_positive(low) { low = middle } else { high = middle }
            }
            found.push(low * low);
        }
        lower = upper;
    }
    found
}

/// Intervals hold the frequencies of a list, in order, one each.
fn hold(found: &[NaturalFrequency], expected: &[DoubleDouble]) {
    assert!(found.len() >= expected.len());
    for (root, omega) in found.iter().zip(expected) {
        let is_inside = double(root.lower) <= *omega && *omega <= double(root.upper);
        assert!(is_inside && root.multiplicity == 1, "{root:?} instead of {omega}");
    }
}

/// Two lists as one.
fn merged(first: Vec<DoubleDouble>, second: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
    let mut all = [first, second].concat();
    all.sort_by(|a, b| a.partial_cmp(b).unwrap());
    all
}

/// Stiffnesses of hinges: perfect, soft, of the beam's size, stiff.
const STIFFNESSES: [f64; 6] = [0.0, 1e-12, 0.25, 3.0, 1e4, 1e12];

/// Closed form: in antisymmetric modes the middle is a pin, `tan z = tanh z`; in symmetric ones each half is a cantilever with a
/// torsion spring of 2K at its end, `z (1 + cos cosh) + 2K (cos sinh + sin cosh) = 0`.
#[test]
fn a_gerber_beam_has_the_modes_of_its_halves() {
    for stiffness in STIFFNESSES {
        let pinned = |z: DoubleDouble| {
            let [sin, cos, tanh, _] = waves(z);
            sin - cos * tanh
        };
        let sprung = |z: DoubleDouble| {
            let [sin, cos, tanh, inverse] = waves(z);
            z * (inverse + cos) + double(2.0 * stiffness) * (cos * tanh + sin)
        };
        let expected = merged(frequencies(6, pinned), frequencies(6, sprung));
        let found = Gerber { stiffness }.build().unwrap().first_frequencies::<10>().unwrap();
        hold(&found, &expected[..10]);
    }
}

/// Closed form: in symmetric modes the middle is guided, `tan z = -tanh z`; in antisymmetric ones each half is a cantilever with a
/// spring of 2K at its end, `z³ (1 + cos cosh) - 2K (cos sinh - sin cosh) = 0`.
#[test]
fn a_shear_hinge_has_the_modes_of_halves_too() {
    for stiffness in STIFFNESSES {
        let guided = |z: DoubleDouble| {
            let [sin, cos, tanh, _] = waves(z);
            sin + cos * tanh
        };
        let sprung = |z: DoubleDouble| {
            let [sin, cos, tanh, inverse] = waves(z);
            z * z * z * (inverse + cos) - double(2.0 * stiffness) * (cos * tanh - sin)
        };
        let expected = merged(frequencies(6, guided), frequencies(6, sprung));
        let found = Sliding { stiffness }.build().unwrap().first_frequencies::<10>().unwrap();
        hold(&found, &expected[..10]);
    }
}

/// The determinant of a square matrix, by columns.
fn determinant(mut columns: Vec<Vec<DoubleDouble>>) -> DoubleDouble {
    let mut product = double(1.0);
    for k in 0..columns.len() {
        let pivot = (k..columns.len()).max_by(|&i, &j| columns[i][k].abs().partial_cmp(&columns[j][k].abs()).unwrap());
        let pivot = pivot.unwrap();
        product = if pivot == k { product } else { -product };
        columns.swap(k, pivot);
        product *= columns[k][k];
        for i in k + 1..columns.len() {
            let factor = columns[i][k] / columns[k][k];
            for row in k..columns[k].len() {
                let entry = factor * columns[k][row];
                columns[i][row] -= entry;
            }
        }
    }
    product
}

/// The 4×4 determinant of a cracked cantilever: amplitudes of `cosh - cos` and `sinh - sin` from the clamp, of `cosh + cos` and
/// `sinh + sin` from the tip, over cosh, with Y, M, Q and the jump of the slope at the crack.
fn cracked(model: &Cracked, z: DoubleDouble) -> DoubleDouble {
    let parts = [(model.from_clamp, -1.0, 1.0), (model.from_tip, 1.0, -1.0)];
    let mut columns = Vec::new();
    for (length, sign, direction) in parts {
        let ([sin, cos, sinh, inverse], direction, sign) = (waves(z * double(length)), double(direction), double(sign));
        let (sin, cos, one) = (sin * inverse * sign, cos * inverse * sign, double(1.0));
        // derivatives with respect to z x of `cosh ± cos` and `sinh ± sin`
        let first = [one + cos, sinh - sin, one - cos, sinh + sin];
        let second = [sinh + sin, one + cos, sinh - sin, one - cos];
        for [y, slope, m, q] in [first, second] {
            let (slope, q) = (slope * direction, q * direction);
            // what the input side adds to `K (Θ_O - Θ_I) - M_I`, the output side with the other sign
            let jump = double(model.stiffness) * slope + if length == model.from_clamp { z * m } else { double(0.0) };
            columns.push(vec![y, m, q, jump].into_iter().map(|entry| entry * direction).collect());
        }
    }
    determinant(columns)
}

#[test]
fn a_cracked_cantilever_has_the_zeros_of_its_determinant() {
    for stiffness in STIFFNESSES {
        let model = Cracked { from_clamp: 0.375, from_tip: 0.625, stiffness };
        let found = model.build().unwrap().first_frequencies::<8>().unwrap();
        // without stiffness the outer part turns freely, with next to none it does slowly
        let low = found.iter().filter(|root| root.omega < 0.25).count();
        assert_eq!(low, usize::from(stiffness < 0.01));
        let near_zero = if stiffness == 0.0 { 0.0 } else { (3.0 * stiffness / 0.625f64.powi(3)).sqrt() };
        assert!(low == 0 || (found[0].omega - near_zero).abs() <= 1e-9 * near_zero, "{:?}, {near_zero}", found[0]);
        hold(&found[low..], &frequencies(8 - low, |z| cracked(&model, z)));
    }
}

system! {
    /// A chain of beams with perfect hinges.
    struct Hinged { a: f64, b: f64, c: f64, k: f64 }
    fixed -> beam 1 { length: a, bending_stiffness: 1.5, mass_per_length: 1.0 } -> hinge 2 { stiffness_rz: 0.0 }
          -> beam 3 { length: b, bending_stiffness: 1.0, mass_per_length: 0.5 } -> conn 4
          -> beam 5 { length: c, bending_stiffness: 2.0, mass_per_length: 1.0 } -> hinge 6 { stiffness_y: 0.0 }
          -> beam 7 { length: a, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
    fixed -> spring 8 { stiffness: k } -> conn 4;
}

system! {
    /// The same by paths of one freedom, whose inertia is zero.
    struct Narrowed { a: f64, b: f64, c: f64, k: f64 }
    fixed -> beam 1 { length: a, bending_stiffness: 1.5, mass_per_length: 1.0 } -> conn 20 -> mass 21 { mass: 0.0 } -> conn 22
          -> beam 3 { length: b, bending_stiffness: 1.0, mass_per_length: 0.5 } -> conn 4
          -> beam 5 { length: c, bending_stiffness: 2.0, mass_per_length: 1.0 } -> conn 60 -> inertia 61 { inertia: 0.0 } -> conn 62
          -> beam 7 { length: a, bending_stiffness: 1.0, mass_per_length: 1.0 } -> pinned;
    fixed -> spring 8 { stiffness: k } -> conn 4;
    free -> conn 22;
    free -> conn 62;
}

/// A hinge without stiffness is a path that takes one freedom on: Δ and all counts are the same.
#[test]
fn a_hinge_without_stiffness_is_a_narrow_path() {
    let (a, b, c, k) = (0.75, 1.25, 0.5, 40.0);
    let hinged = Hinged { a, b, c, k }.build().unwrap();
    let narrowed = Narrowed { a, b, c, k }.build().unwrap();
    for step in 1..400 {
        let omega = 0.37 * f64::from(step);
        assert_eq!(hinged.count_below(omega).unwrap(), narrowed.count_below(omega).unwrap(), "{omega}");
        let [one, other] = [hinged.characteristic(omega), narrowed.characteristic(omega)];
        let quotient = one.mantissa() / other.mantissa() * 2f64.powi((one.exponent() - other.exponent()) as i32);
        assert!((quotient.abs() - 1.0).abs() < 1e-11, "{quotient} at {omega}");
    }
    let [one, other] = [hinged.first_frequencies::<12>().unwrap(), narrowed.first_frequencies::<12>().unwrap()];
    for (one, other) in one.iter().zip(other.iter()) {
        assert!(one.lower <= other.upper && other.lower <= one.upper, "{one:?} {other:?}");
    }
}

/// The transfer matrix of a perfect hinge has no number at (Θ, M): the paper's search says so, and the certified one does not need it.
#[test]
fn the_overall_matrix_of_a_perfect_hinge_is_refused() {
    let system = Gerber { stiffness: 0.0 }.build().unwrap();
    assert!(system.overall_determinant(1.0).mantissa().is_nan());
    let search = fmin1d::<8, _>(|omega| system.overall_determinant(omega), 1.0..=30.0, 50, 1e-9);
    assert!(matches!(search, Err(SearchError::NotANumber { .. })), "{search:?}");
    assert_eq!(system.count_below(30.0), Ok(3));
}

/// Δ is K times the determinant of the overall matrix, up to the sign, where waves are short enough for that to keep its digits.
#[test]
fn the_determinant_is_that_of_the_overall_matrix() {
    for stiffness in [0.25, 3.0, 50.0] {
        let (gerber, sliding) = (Gerber { stiffness }.build().unwrap(), Sliding { stiffness }.build().unwrap());
        for omega in [0.5, 3.0, 7.0] {
            let pairs = [
                (gerber.overall_determinant(omega), gerber.characteristic(omega)),
                (sliding.overall_determinant(omega), sliding.characteristic(omega)),
            ];
            for (overall, delta) in pairs {
                let quotient = delta.value() / (overall.value() * stiffness);
                assert!((quotient.abs() - 1.0).abs() < 1e-10, "{quotient} for {stiffness} at {omega}");
            }
        }
    }
}

system! {
    /// A beam that hangs on a hinge without stiffness at a free end turns as it likes at any frequency.
    struct Loose { length: f64 }
    free -> hinge 1 { stiffness_rz: 0.0 } -> beam 2 { length, bending_stiffness: 1.0, mass_per_length: 1.0 } -> fixed;
}

/// What has neither stiffness nor inertia moves at every frequency: Δ vanishes there, which the search says.
#[test]
fn a_massless_mechanism_is_refused() {
    let system = Loose { length: 1.0 }.build().unwrap();
    assert!(matches!(system.first_frequencies::<2>(), Err(SearchError::Zero { .. })));
}

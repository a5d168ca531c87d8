//! Oracles: double-double arithmetic, complex functions of the root, addition theorems, differences.

use super::*;
use crate::number::double_double::DoubleDouble;
use crate::number::dual::Dual;
use crate::number::frequency::Parameter;
use crate::number::tolerance::assert_close;
use num_complex::Complex64;
use proptest::prelude::*;

fn wide(number: f64) -> DoubleDouble {
    DoubleDouble::from_f64(number)
}

/// Both functions in plain numbers.
fn plain<S: Scalar>(square: S) -> [S; 2] {
    let EvenWaves { cosh, sinhc, exponent, .. } = square.even_waves();
    [cosh, sinhc].map(|value| value.times_power_of_two(exponent))
}

/// Both functions by doubling the wave number, from a square whose series is short.
fn doubled(square: DoubleDouble) -> [DoubleDouble; 2] {
    let [beyond_one, sinhc] = doubled_beyond_one(square);
    [wide(1.0) + beyond_one, sinhc]
}

/// `V = C - 1` and S: `V(4κ) = 2V (V + 2)`, `S(4κ) = (1 + V) S`, in which errors do not grow as those of `2C² - 1` would.
fn doubled_beyond_one(square: DoubleDouble) -> [DoubleDouble; 2] {
    if square.size() < 1e-3 {
        let mut terms = [wide(1.0); 2];
        let mut sums = [wide(0.0), wide(1.0)];
        for k in 1..8 {
            for (parity, (term, sum)) in terms.iter_mut().zip(&mut sums).enumerate() {
                let n = (2 * k + parity) as f64;
                *term = *term * square / wide(n * (n - 1.0));
                *sum += *term;
            }
        }
        return sums;
    }
    let [beyond_one, sinhc] = doubled_beyond_one(square.times_power_of_two(-2));
    [(beyond_one * (beyond_one + wide(2.0))).times_power_of_two(1), (wide(1.0) + beyond_one) * sinhc]
}

proptest! {
    /// Oracle: double-double arithmetic. The root carries half an eps, a phase or a factor.
    #[test]
    fn doubles_are_those_of_twice_the_digits(size in -3.0..7.9f64, is_negative: bool) {
        let square = if is_negative { -10f64.powf(size) } else { 10f64.powf(0.5 * size) };
        let phase = 1.0 + square.abs().sqrt();
        let (found, exact) = (plain(square), plain(wide(square)));
        let scale = if is_negative { 1.0 } else { exact[0].to_f64() };
        for ((found, exact), unit) in found.into_iter().zip(exact).zip([1.0, 1.0 / square.abs().sqrt().max(1.0)]) {
            let error = (wide(found) - exact).size();
            prop_assert!(error <= 3.0 * phase * f64::EPSILON * scale * unit, "{square}: {error:e}");
        }
    }

    /// Oracle: addition theorems, whose errors double with the wave number.
    #[test]
    fn double_doubles_obey_the_addition_theorems(size in -3.0..3.0f64, is_negative: bool, low in -1.0..1.0f64) {
        let square = wide(if is_negative { -1.0 } else { 1.0 } * 10f64.powf(size)) * (wide(1.0) + wide(1e-20 * low));
        let scale = if is_negative { 1.0 } else { plain(square)[0].size() };
        for (found, expected) in plain(square).into_iter().zip(doubled(square)) {
            let bound = 1e3 * (1.0 + square.size()) * DoubleDouble::EPSILON * scale;
            prop_assert!((found - expected).size() <= bound, "{square:?}: {:e}", (found - expected).size());
        }
    }

    /// Oracle: functions of the standard library of the complex root.
    #[test]
    fn complex_squares_have_the_functions_of_their_root(size in -2.0..5.0f64, angle in -3.2..3.2f64) {
        let square = Complex64::from_polar(10f64.powf(size), angle);
        let root = square.sqrt();
        let scale = (2.0 + root.norm()) * root.re.cosh();
        for (found, expected) in plain(square).into_iter().zip([root.cosh(), root.sinh() / root]) {
            assert_close((found - expected).norm(), 0.0, scale, 4.0);
        }
    }

    /// Oracle: central differences in double-double arithmetic, through zero as well.
    #[test]
    fn slopes_are_differences(size in -6.0..4.0f64, sign in -1i32..=1) {
        let square = f64::from(sign) * 10f64.powf(size);
        let step = wide(1e-9);
        let [ahead, behind] = [wide(square) + step, wide(square) - step].map(plain);
        let found = plain(Dual { value: square, derivative: 1.5 });
        let scale = if sign < 0 { 1.0 } else { plain(square)[0] } * (1.0 + square.abs().sqrt());
        for k in 0..2 {
            let slope = ((ahead[k] - behind[k]) / (step + step)).to_f64();
            prop_assert!((found[k].derivative - 1.5 * slope).abs() <= 8.0 * f64::EPSILON * scale, "{square}, {k}");
            prop_assert_eq!(found[k].value, plain(square)[k]);
        }
    }
}

/// Closed form: `cosh √κ = e^√κ / 2` and `sinh √κ / √κ = e^√κ / 2√κ` beyond the range of `f64`, by their logarithm.
#[test]
fn nothing_overflows_where_waves_decay() {
    for root in [99.999, 100.001, 800.0, 3e5_f64] {
        for square in [Complex64::from(root * root), Complex64::new(root, 1e-3) * Complex64::new(root, 1e-3)] {
            let EvenWaves { cosh, sinhc, one, exponent } = square.even_waves();
            let logarithm = |value: f64| value.ln() + f64::from(exponent) * core::f64::consts::LN_2;
            assert_close(logarithm(cosh.norm()), root - core::f64::consts::LN_2, root, 8.0);
            assert_close((sinhc * square.sqrt() / cosh - Complex64::ONE).norm(), 0.0, 1.0, 8.0);
            assert_eq!(one.re, 1.0.times_power_of_two(-exponent));
        }
        let real = (root * root).even_waves();
        let complex = Complex64::from(root * root).even_waves();
        assert_eq!((real.cosh, real.exponent), (complex.cosh.re, complex.exponent));
        let slopes = real.slopes(root * root);
        assert_close(slopes[0] / real.cosh * 2.0 * root, 1.0, 1.0, 8.0);
        assert_close(slopes[1] / real.cosh * 2.0 * root * root, 1.0 - 1.0 / root, 1.0, 8.0);
    }
}

/// Closed form: the limits at zero, and no number where there is none.
#[test]
fn ends_of_the_range() {
    let waves = Dual { value: 0.0, derivative: 6.0 }.even_waves();
    assert_eq!((waves.cosh.value, waves.sinhc.value), (1.0, 1.0));
    assert_eq!((waves.cosh.derivative, waves.sinhc.derivative), (3.0, 1.0));
    assert!(plain(f64::NAN).iter().all(|value| value.is_nan()));
    let phase = 3e6_f64;
    assert_close(plain(-phase * phase)[0], phase.cos(), 1.0, 4.0);
}

//! Logarithms and angles to all digits of a number, from those of an `f64`.

use crate::number::constants::HALF_PI;
use crate::number::exponent::binary_exponent;
use crate::number::floats::{argument, logarithm};
use crate::number::frequency::Real;
use crate::number::scalar::twice;
use num_complex::Complex;

/// Largest distance of a ratio from 1 up to which the series alone serves.
const NEAR: f64 = 0.25;

/// Binary digits that a term of the series adds at that distance: `z² <= 1/49`.
const DIGITS_OF_A_TERM: i32 = 5;

/// Ratios beyond which the exponential of their logarithm may leave the range.
const IN_RANGE: core::ops::Range<f64> = 1e-300..1e300;

/// `ln(to/from)` of two positive numbers, without cancellation where they are close: `2 artanh((to - from)/(to + from))`.
pub(crate) fn logarithm_of_ratio<T: Real>(to: T, from: T) -> T {
    let ratio = to.to_f64() / from.to_f64();
    if !IN_RANGE.contains(&ratio) {
        // of zero, infinite and no numbers there is none
        let is_finite = to > T::zero() && from > T::zero() && (to + from).size().is_finite();
        return if is_finite { twice(logarithm_of_ratio(to.sqrt(), from.sqrt())) } else { T::from_f64(f64::NAN) };
    }
    let near = T::from_f64(if (ratio - 1.0).abs() < NEAR { 0.0 } else { logarithm(ratio) });
    let reached = from * near.exp();
    let part = (to - reached) / (to + reached);
    let square = part * part;
    let terms = 2 - binary_exponent(T::EPSILON) / DIGITS_OF_A_TERM;
    let series = (0..terms).rev().fold(T::zero(), |sum, n| sum * square + T::one() / T::from_f64(f64::from(2 * n + 1)));
    near + twice(part * series)
}

/// 2π, in two words.
pub(crate) fn turn<T: Real>() -> T {
    T::of_words([HALF_PI[0], HALF_PI[1]]) * T::from_f64(4.0)
}

/// The argument of a complex number, from -π to π.
pub(crate) fn angle<T: Real>(z: Complex<T>) -> T {
    let near = T::from_f64(argument(z.re.to_f64(), z.im.to_f64()));
    let (sin, cos) = near.sin_cos();
    // what is left is a rounding of `near`, and its own tangent
    near + (z.im * cos - z.re * sin) / (z.re * cos + z.im * sin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::double_double::DoubleDouble;
    use crate::number::exponentials::exponential;
    use crate::number::frequency::Parameter;
    use crate::number::scalar::Scalar;

    /// Oracle: the exponential, in both precisions.
    #[test]
    fn logarithms_are_those_whose_exponential_is_the_ratio() {
        let wide = DoubleDouble::from_f64;
        for from in [3e-7, 1.0, 4.1e5] {
            for ratio in [1e-30, 0.3, 0.75, 0.7500001, 0.999, 1.0 + 1e-9, 1.2499, 1.25, 2.0, 17.3, 1e200] {
                let to = from * ratio;
                let exact = logarithm_of_ratio(wide(to), wide(from));
                let left = exact.exp() * wide(from) / wide(to) - wide(1.0);
                assert!(left.size() < 1e-29 * (1.0 + exact.size()), "{from} {ratio}: {left:?}");
                let found = logarithm_of_ratio(to, from);
                let error = (wide(found) - exact).size() / exact.size();
                assert!(error < 4e-16, "{from} {ratio}: {error:e}");
            }
        }
    }

    /// Closed form: powers of two beyond the range of a ratio.
    #[test]
    fn logarithms_of_ratios_beyond_the_range() {
        let ln_2 = core::f64::consts::LN_2;
        let found = logarithm_of_ratio(2.0_f64.powi(1000), 2.0_f64.powi(-1040));
        assert!((found / (2040.0 * ln_2) - 1.0).abs() < 4e-16, "{found}");
        let found = logarithm_of_ratio(f64::from_bits(1), 1e300);
        assert!((found + 1074.0 * ln_2 + 1e300_f64.ln()).abs() < 1e-12, "{found}");
        for (to, from) in [(0.0, 1.0), (1.0, 0.0), (f64::INFINITY, 1.0), (f64::NAN, 1.0), (-1.0, 2.0)] {
            assert!(logarithm_of_ratio(to, from).is_nan(), "{to} {from}");
        }
    }

    /// Oracle: the exponential of an imaginary number.
    #[test]
    fn angles_are_those_of_exponentials() {
        for given in [-3.1, -1.5, -1e-12, 0.0, 1e-20, 0.7, 1.6, 3.0] {
            let given = DoubleDouble::from_f64(given);
            let found =
                angle(exponential(Complex::new(DoubleDouble::from_f64(0.0), given)) * DoubleDouble::from_f64(7.0));
            let error = (found - given).size();
            assert!(error <= 1e-30 * given.to_f64().abs().max(1e-2), "{given:?}: {error:e}");
        }
        assert_eq!(angle(Complex::new(-2.0, 0.0)), core::f64::consts::PI);
    }
}

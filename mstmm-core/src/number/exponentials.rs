//! The exponential of a complex number, and its remainders without the first terms.

use crate::number::frequency::Real;
use crate::number::scalar::Scalar;
use num_complex::Complex;
use num_traits::Zero;

/// `e^z`.
pub(crate) fn exponential<T: Real>(z: Complex<T>) -> Complex<T> {
    let (sin, cos) = z.im.sin_cos();
    Complex::new(cos, sin) * z.re.exp()
}

/// `φ₁(z) = (e^z - 1)/z = ∫₀¹ e^{z(1-s)} ds`, without cancellation.
pub(crate) fn phi_1<T: Real>(z: Complex<T>) -> Complex<T> {
    if is_small(z) { series(z, 1) } else { (exponential(z) - Complex::from(T::one())) / z }
}

/// `φ₂(z) = (e^z - 1 - z)/z² = ∫₀¹ e^{z(1-s)} s ds`, without cancellation.
pub(crate) fn phi_2<T: Real>(z: Complex<T>) -> Complex<T> {
    if is_small(z) { series(z, 2) } else { (phi_1(z) - Complex::from(T::one())) / z }
}

/// Where the series is exact to rounding: `|z|^n/n!` with the last n of the table is below 1e-10, 1e-20 and 1e-41 for
/// `f32`, `f64` and `DoubleDouble`.
fn is_small<T: Real>(z: Complex<T>) -> bool {
    z.size() <= 1.0
}

/// `Σ_k z^k/(k + first)!` by Horner's rule.
fn series<T: Real>(z: Complex<T>, first: usize) -> Complex<T> {
    let last = 4 * T::SERIES_TERMS;
    (first..=last).rev().fold(Complex::zero(), |sum, n| sum * z + Complex::from(T::reciprocal_factorial(n)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::double_double::DoubleDouble;
    use crate::number::frequency::Parameter;
    use crate::number::tolerance::assert_close;

    fn wide(z: Complex<f64>) -> Complex<DoubleDouble> {
        Complex::new(DoubleDouble::from_f64(z.re), DoubleDouble::from_f64(z.im))
    }

    /// Oracle: the definitions in 32 digits, of which a small z takes no more than 12.
    #[test]
    fn agree_with_their_definitions_in_twice_the_digits() {
        let one = Complex::from(DoubleDouble::from_f64(1.0));
        for (re, im) in [(1.0, 0.3), (-1.0, 1.0), (0.0, 1.0), (-0.6, 0.8), (-1.0, 0.0)] {
            for size in [1e-6, 1e-3, 0.5, 0.999, 1.001, 3.0, 20.0] {
                let z = Complex::new(re * size, im * size);
                let (w, growth) = (wide(z), exponential(wide(z)));
                let expected = [growth, (growth - one) / w, (growth - one - w) / (w * w)];
                for (actual, expected) in [exponential(z), phi_1(z), phi_2(z)].into_iter().zip(expected) {
                    let expected = Complex::new(expected.re.to_f64(), expected.im.to_f64());
                    assert_close((actual - expected).size(), 0.0, expected.size(), 16.0);
                }
            }
        }
    }

    /// Closed form: the limits at zero.
    #[test]
    fn are_known_at_zero() {
        let zero = Complex::<f64>::zero();
        assert_eq!((exponential(zero).re, phi_1(zero).re, phi_2(zero).re), (1.0, 1.0, 0.5));
        assert!(phi_2(Complex::new(f64::NAN, 0.0)).re.is_nan());
    }
}

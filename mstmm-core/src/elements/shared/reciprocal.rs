//! Reciprocals of dynamic stiffnesses beside the poles of transfer matrices.

use crate::number::exponent::binary_exponent;
use crate::number::scalar::Scalar;

/// A dynamic stiffness κ and its reciprocal, for κ of any size. Where the reciprocal is not finite, at the pole of the
/// transfer matrix or for a damper without damping, a number so small takes the place of κ that the product with the
/// denominator does not show it.
pub(crate) fn off_pole<S: Scalar>(kappa: S) -> (S, S) {
    // a complex division alone squares the modulus, which vanishes at half the range
    let shift = -binary_exponent(kappa.size());
    let reciprocal = (S::one() / kappa.times_power_of_two(shift)).times_power_of_two(shift);
    if reciprocal.size().is_finite() || !kappa.size().is_finite() {
        return (kappa, reciprocal);
    }
    let power = |exponent| S::one().times_power_of_two(exponent);
    (power(-100), power(100))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::tolerance::assert_close;
    use num_complex::Complex;

    #[test]
    fn a_stiffness_of_any_size_has_a_finite_reciprocal() {
        for size in [1e-307, 1e-170, 1e-100, 1.0, 1e100, 1e200] {
            let kappa = Complex::new(size, size);
            let (same, reciprocal) = off_pole(kappa);
            assert_eq!(same, kappa);
            assert_close((reciprocal * size - Complex::new(0.5, -0.5)).norm(), 0.0, 1.0, 4.0);
        }
        for size in [0.0, 5e-324, 1e-320] {
            let (kappa, reciprocal) = off_pole(Complex::new(size, -size));
            assert_eq!(kappa * reciprocal, Complex::ONE);
        }
        assert!(off_pole(Complex::new(f64::NAN, 0.0)).0.is_nan());
    }
}

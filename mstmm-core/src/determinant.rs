//! Determinants of small matrices over any scalar.

use crate::scalar::Scalar;
use crate::scaled::{Scaled, binary_exponent};
use nalgebra::SMatrix;

/// Determinant by Gaussian elimination with row pivoting, with mantissa and exponent apart.
///
/// ```
/// use mstmm_core::determinant;
/// let matrix = nalgebra::Matrix2::<f64>::new(1e200, 2e200, 3e200, 4e200);
/// let value = determinant(matrix);
/// assert_eq!(value.times(1e-200).times(1e-200).value().round(), -2.0);
/// ```
pub fn determinant<S: Scalar, const N: usize>(mut matrix: SMatrix<S, N, N>) -> Scaled<S> {
    let mut product = Scaled::new(S::one(), 0);
    for column in 0..N {
        let pivot_row = largest_below(&matrix, column);
        let pivot = matrix[(pivot_row, column)];
        product = product.times(if pivot_row == column { pivot } else { -pivot });
        if pivot.is_zero() {
            return product;
        }
        matrix.swap_rows(pivot_row, column);
        // a complex division squares the modulus of its divisor, which overflows or vanishes at half the range
        let shift = -binary_exponent(pivot.size());
        let pivot = pivot.times_power_of_two(shift);
        for row in column + 1..N {
            let factor = matrix[(row, column)].times_power_of_two(shift) / pivot;
            for k in column + 1..N {
                let change = factor * matrix[(column, k)];
                matrix[(row, k)] -= change;
            }
        }
    }
    product
}

/// Row of the largest entry on or below the diagonal of a column; a NaN counts as largest, so that it is not lost.
fn largest_below<S: Scalar, const N: usize>(matrix: &SMatrix<S, N, N>, column: usize) -> usize {
    let mut best = column;
    for row in column + 1..N {
        let (size, best_size) = (matrix[(row, column)].size(), matrix[(best, column)].size());
        if size.is_nan() || size > best_size {
            best = row;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::assert_close;
    use nalgebra::{Matrix3, SMatrix};
    use num_complex::Complex;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn equals_the_expansion_by_permutations(entries in proptest::array::uniform9(-1.0..1.0f64)) {
            let m = Matrix3::from_row_slice(&entries);
            let expected = m[(0, 0)] * (m[(1, 1)] * m[(2, 2)] - m[(1, 2)] * m[(2, 1)])
                - m[(0, 1)] * (m[(1, 0)] * m[(2, 2)] - m[(1, 2)] * m[(2, 0)])
                + m[(0, 2)] * (m[(1, 0)] * m[(2, 1)] - m[(1, 1)] * m[(2, 0)]);
            // backward error of elimination: a few units of n · eps times the size of the terms
            assert_close(determinant(m).value(), expected, 6.0, 9.0);
        }
    }

    #[test]
    fn a_row_exchange_changes_the_sign() {
        let m = SMatrix::<f64, 2, 2>::new(0.0, 1.0, 1.0, 0.0);
        assert_eq!(determinant(m).value(), -1.0);
    }

    #[test]
    fn complex_entries_may_be_as_large_and_as_small_as_real_ones() {
        type C = Complex<f64>;
        let matrix = SMatrix::<C, 2, 2>::new(1e160.into(), 1e160.into(), 1e100.into(), 2e100.into());
        assert_close(determinant(matrix).value().re, 1e260, 1e260, 8.0);
        for size in [1e-300, 1e-160, 1e160, 1e300] {
            // columns in the directions 1 and i: the determinant is 3i - 2i
            let i = C::i();
            let matrix = SMatrix::<C, 2, 2>::new(1.0.into(), i, 2.0.into(), i * 3.0) * C::from(size);
            let value = determinant(matrix).times(C::from(1.0 / size)).times(C::from(1.0 / size)).value();
            assert_close((value - i).norm(), 0.0, 5.0, 4.0);
        }
    }

    #[test]
    fn singular_is_zero_and_nan_stays_nan() {
        assert_eq!(determinant(SMatrix::<f64, 3, 3>::zeros()).value(), 0.0);
        let mut m = SMatrix::<f64, 3, 3>::identity();
        m[(2, 0)] = f64::NAN;
        assert!(determinant(m).value().is_nan());
    }
}

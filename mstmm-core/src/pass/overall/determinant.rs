//! Determinants of small matrices over any scalar.

use crate::number::{Scaled, Single, binary_exponent};
use nalgebra::SMatrix;

/// Determinant by Gaussian elimination with row pivoting, with mantissa and exponent apart.
///
/// ```
/// use mstmm_core::determinant;
/// let matrix = nalgebra::Matrix2::<f64>::new(1e200, 2e200, 3e200, 4e200);
/// let value = determinant(matrix);
/// assert_eq!(value.times(1e-200).times(1e-200).value().round(), -2.0);
/// ```
pub fn determinant<S: Single, const N: usize>(mut matrix: SMatrix<S, N, N>) -> Scaled<S> {
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
fn largest_below<S: Single, const N: usize>(matrix: &SMatrix<S, N, N>, column: usize) -> usize {
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
    use crate::element::{Element, TransferMatrix};
    use crate::elements::Beam;
    use crate::number::assert_close;
    use core::f64::consts::PI;
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

    /// βl of a mode: `cos βl cosh βl = -1` of a cantilever by Newton's method, or that of a pinned beam.
    fn beta_l(mode: f64, pinned: bool) -> f64 {
        let mut beta_l = PI * if pinned { mode } else { mode - 0.5 };
        for _ in 0..4 {
            beta_l += if pinned { 0.0 } else { (beta_l.cos() + 1.0 / beta_l.cosh()) / beta_l.sin() };
        }
        beta_l
    }

    /// Whether the determinant of a beam is positive.
    fn is_positive(beta_l: f64, pinned: bool) -> bool {
        let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 }.build().unwrap();
        let u = Beam::transfer_matrix(&beam, beta_l * beta_l);
        let (rows, columns) = if pinned { ([0, 2], [1, 3]) } else { ([2, 3], [2, 3]) };
        determinant(SMatrix::<f64, 2, 2>::from_fn(|i, k| u[(rows[i], columns[k])])).mantissa() > 0.0
    }

    /// The accuracy that the README states: within these relative distances of a root ω the sign is wrong now and then,
    /// outside never. Oracle: one change of sign in 1 % on either side of each root.
    #[test]
    fn roots_of_a_beam_are_as_uncertain_as_stated() {
        for (mode, stated) in [(6.0, 1e-9), (8.0, 4e-7), (10.0, 2e-4)] {
            for pinned in [false, true] {
                let root = beta_l(mode, pinned);
                let at = |distance: f64| is_positive(root * (1.0 + distance).sqrt(), pinned);
                let wrong = |distance: f64| at(distance) != at(0.01) || at(-distance) != at(-0.01);
                assert_ne!(at(0.01), at(-0.01));
                let first = |from: f64, to: f64| {
                    let steps = (0..2000).map(|k| from * (to / from).powf(f64::from(k) / 2000.0));
                    steps.into_iter().find(|&distance| wrong(distance))
                };
                assert_eq!(first(stated, 0.01), None, "mode {mode}, pinned: {pinned}");
                assert!(first(stated / 10.0, stated).is_some(), "mode {mode}, pinned: {pinned}: better than stated");
            }
        }
    }
}

//! The inverse of a complex matrix in words: nothing is promised of it.

use crate::proof::disc::complex::modulus;
use num_complex::Complex;

/// Puts nearly its inverse in the place of a square matrix, row after row (Gauss and Jordan, with pivots by columns), given memory for the rows
/// of pivots. Returns whether all pivots are numbers.
pub(crate) fn invert(matrix: &mut [Complex<f64>], pivots: &mut [usize]) -> bool {
    let n = pivots.len();
    let at = |row: usize, column: usize| row * n + column;
    for k in 0..n {
        let size = |row: usize| modulus(matrix[at(row, k)].re, matrix[at(row, k)].im);
        let pivot = (k..n).max_by(|a, b| size(*a).total_cmp(&size(*b))).unwrap_or(k);
        let inverse = Complex::from(1.0) / matrix[at(pivot, k)];
        if !(inverse.re.is_finite() && inverse.im.is_finite()) {
            return false;
        }
        pivots[k] = pivot;
        for column in 0..n {
            matrix.swap(at(k, column), at(pivot, column));
        }
        matrix[at(k, k)] = Complex::from(1.0);
        for column in 0..n {
            matrix[at(k, column)] *= inverse;
        }
        for row in (0..n).filter(|row| *row != k) {
            let factor = matrix[at(row, k)];
            if factor == Complex::from(0.0) {
                continue;
            }
            matrix[at(row, k)] = Complex::from(0.0);
            for column in 0..n {
                let product = factor * matrix[at(k, column)];
                matrix[at(row, column)] -= product;
            }
        }
    }
    for k in (0..n).rev() {
        for row in 0..n {
            matrix.swap(at(row, k), at(row, pivots[k]));
        }
    }
    true
}

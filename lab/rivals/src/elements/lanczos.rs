//! The eigenvalues nearest to a shift of `K x = ω² M x`, by Lanczos' method on `(K - σM)⁻¹ M`.

use super::assembly::Matrices;
use nalgebra::{DMatrix, DVector};

/// A start vector with a share of every mode: a fixed sequence without pattern.
pub(super) fn start_vector(size: usize) -> DVector<f64> {
    // fractional parts of multiples of the golden ratio
    DVector::from_fn(size, |k, _| ((k + 1) as f64 * 0.618_033_988_749_894_9).fract() + 0.25)
}

/// The `wanted` squares of frequencies nearest to a shift, nearest first, from a Krylov space of a dimension.
///
/// Vectors are kept orthogonal in the inner product of M, all of them: a few more products for no spurious copies.
///
/// # Source
/// Ericsson and Ruhe (1980), the spectral transformation Lanczos method.
pub fn nearest(matrices: &Matrices, shift: f64, wanted: usize, dimension: usize) -> Vec<f64> {
    let size = matrices.mass.size();
    let dimension = dimension.min(size);
    let factors = matrices.stiffness.plus(-shift, &matrices.mass).factorised();
    let mut basis = DMatrix::zeros(size, dimension);
    let mut weighted = DMatrix::zeros(size, dimension);
    let mut tridiagonal = DMatrix::zeros(dimension, dimension);
    let mut vector = start_vector(size);
    let mut mass_times = DVector::zeros(size);
    let mut overlaps = DVector::zeros(dimension);
    for step in 0..dimension {
        matrices.mass.times(vector.as_slice(), mass_times.as_mut_slice());
        let norm = vector.dot(&mass_times).sqrt();
        if step > 0 {
            tridiagonal[(step, step - 1)] = norm;
            tridiagonal[(step - 1, step)] = norm;
        }
        basis.column_mut(step).axpy(1.0 / norm, &vector, 0.0);
        weighted.column_mut(step).axpy(1.0 / norm, &mass_times, 0.0);
        vector.copy_from(&weighted.column(step));
        factors.solve(vector.as_mut_slice());
        tridiagonal[(step, step)] = vector.dot(&weighted.column(step));
        let (known, weights) = (basis.columns(0, step + 1), weighted.columns(0, step + 1));
        let mut overlaps = overlaps.rows_mut(0, step + 1);
        overlaps.gemv_tr(1.0, &weights, &vector, 0.0);
        vector.gemv(-1.0, &known, &overlaps, 1.0);
    }
    let mut inverses = tridiagonal.symmetric_eigenvalues();
    inverses.as_mut_slice().sort_by(|a, b| b.abs().total_cmp(&a.abs()));
    inverses.iter().take(wanted).map(|inverse| shift + 1.0 / inverse).collect()
}

//! The eigenvalues of least modulus of `(λ²M + λC + K) q = 0`, by Arnoldi's method on the inverse of its companion form.

use super::assembly::Matrices;
use super::lanczos::start_vector;
use super::skyline::Skyline;
use nalgebra::{Complex, DMatrix, DVector};

/// The `wanted` eigenvalues of least modulus in the upper half plane, by ascending imaginary part.
///
/// With `z = λq` the companion form is `(q, z) = λ (-K⁻¹(C q + M z), q)`. Vectors are orthogonal in the inner product of the
/// energy, `qᵀKq + zᵀMz`, in which an undamped system is a skew matrix: its eigenvalues converge twice as fast as in others.
///
/// # Source
/// Saad, Numerical Methods for Large Eigenvalue Problems (2011), chapters 6 and 9.
pub fn lowest(matrices: &Matrices, wanted: usize, dimension: usize) -> Vec<Complex<f64>> {
    let size = matrices.mass.size();
    let dimension = dimension.min(2 * size);
    let factors = matrices.stiffness.clone().factorised();
    let mut basis = DMatrix::zeros(2 * size, dimension);
    let mut weighted = DMatrix::zeros(2 * size, dimension);
    let mut hessenberg = DMatrix::zeros(dimension, dimension);
    let mut vector = DVector::zeros(2 * size);
    let mut weights = DVector::zeros(2 * size);
    let start = start_vector(size);
    let mut overlaps = DVector::zeros(dimension);
    let mut damped = DVector::zeros(size);
    vector.rows_mut(0, size).copy_from(&start);
    matrices.stiffness.times(start.as_slice(), &mut weights.as_mut_slice()[..size]);
    for step in 0..dimension {
        let norm = vector.dot(&weights).sqrt();
        if step > 0 {
            hessenberg[(step, step - 1)] = norm;
        }
        basis.column_mut(step).axpy(1.0 / norm, &vector, 0.0);
        weighted.column_mut(step).axpy(1.0 / norm, &weights, 0.0);
        let (column, weighted_column) = (basis.column(step), weighted.column(step));
        let (q, mass_times_z) = (&column.as_slice()[..size], &weighted_column.as_slice()[size..]);
        multiply(matrices.damping.as_ref(), q, damped.as_mut_slice());
        for row in 0..size {
            let force = -(damped[row] + mass_times_z[row]);
            (vector[row], weights[row]) = (force, force);
            vector[size + row] = q[row];
        }
        factors.solve(&mut vector.as_mut_slice()[..size]);
        matrices.mass.times(q, &mut weights.as_mut_slice()[size..]);
        let mut overlaps = overlaps.rows_mut(0, step + 1);
        overlaps.gemv_tr(1.0, &weighted.columns(0, step + 1), &vector, 0.0);
        vector.gemv(-1.0, &basis.columns(0, step + 1), &overlaps, 1.0);
        weights.gemv(-1.0, &weighted.columns(0, step + 1), &overlaps, 1.0);
        hessenberg.view_mut((0, step), (step + 1, 1)).copy_from(&overlaps);
    }
    upper(hessenberg.complex_eigenvalues().iter().map(|inverse| inverse.inv()), wanted)
}

/// The product with a matrix, or zero without one.
fn multiply(matrix: Option<&Skyline>, x: &[f64], product: &mut [f64]) {
    match matrix {
        Some(matrix) => matrix.times(x, product),
        None => product.fill(0.0),
    }
}

/// Those of least modulus in the upper half plane, by ascending imaginary part.
pub(crate) fn upper(all: impl Iterator<Item = Complex<f64>>, wanted: usize) -> Vec<Complex<f64>> {
    let mut found: Vec<Complex<f64>> = all.filter(|lambda| lambda.im > 0.0).collect();
    found.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    found.truncate(wanted);
    found.sort_by(|a, b| a.im.total_cmp(&b.im));
    found
}

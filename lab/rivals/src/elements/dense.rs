//! All eigenvalues of `K x = ω² M x` at once, where a single Krylov space would not tell close ones apart.

use super::assembly::Matrices;

/// The `wanted` smallest squares of frequencies, by Cholesky's factors of K and the symmetric QR algorithm on `L⁻¹ M L⁻ᵀ`,
/// whose largest eigenvalues, the best ones, are the inverses of those wanted. None where K is not positive definite.
pub fn lowest(matrices: &Matrices, wanted: usize) -> Vec<f64> {
    let Some(factors) = matrices.stiffness.dense().cholesky() else { return Vec::new() };
    let l = factors.l_dirty();
    let mut inverse = matrices.mass.dense();
    l.solve_lower_triangular_mut(&mut inverse);
    inverse.transpose_mut();
    l.solve_lower_triangular_mut(&mut inverse);
    let mut inverses = inverse.symmetric_eigenvalues();
    inverses.as_mut_slice().sort_by(|a, b| b.total_cmp(a));
    inverses.iter().take(wanted).map(|inverse| 1.0 / inverse).collect()
}

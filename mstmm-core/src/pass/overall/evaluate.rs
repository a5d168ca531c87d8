//! Evaluation of the overall transfer equation of a built system.

use crate::number::{Scalar, Scaled};

/// A built system, evaluated at a frequency `x`: ω for a real scalar (undamped systems only), λ for a complex one.
pub trait Evaluate<S: Scalar> {
    /// `SMatrix<S, N, N>`, with `N` the number of unknowns at the boundaries.
    type Matrix;

    /// The reduced overall matrix of `U_all z_all = 0`: main transfer equation first, then the geometrical equations;
    /// columns by tips, the root's last. Of plane structures with loops the columns of cuts come first.
    ///
    /// # Source
    /// Eqs. (30), (35), (36), (40) of the paper, boundary zeros removed.
    fn overall_matrix(&self, x: S) -> Self::Matrix;

    /// `det U_all` times the dashpots' `K + Cλ`, an entire function of λ whose zeros are the eigenvalues.
    ///
    /// In double precision its zeros are good for the first six modes or so: in the tenth of a single beam they are wrong
    /// from the fifth digit on. Only the product of the pivots has an exponent of its own. The states before are plain
    /// numbers: where the βl of the beams of a path add up to about 700, less the logarithm of the largest EIβ³, they
    /// leave the range of `f64`, and the mantissa is not finite.
    fn overall_determinant(&self, x: S) -> Scaled<S>;
}

//! The transfer matrix of a planar member whose bending and stretching do not couple.

use crate::number::Scalar;
use nalgebra::{Matrix2, Matrix4, Matrix6};

/// Rows of `[Y, Θ, M, Q]` and of `[X, Qx]` among those of `[X, Y, Θ, M, Qx, Qy]`.
const BENDING: [usize; 4] = [1, 2, 3, 5];
const LONGITUDINAL: [usize; 2] = [0, 4];

/// The matrix of a member from those of its bending and of its stretching.
pub(crate) fn planar_matrix<S: Scalar>(bending: &Matrix4<S>, longitudinal: &Matrix2<S>) -> Matrix6<S> {
    let mut u = Matrix6::from_element(S::zero());
    for (row, &planar_row) in BENDING.iter().enumerate() {
        for (column, &planar_column) in BENDING.iter().enumerate() {
            u[(planar_row, planar_column)] = bending[(row, column)];
        }
    }
    for (row, &planar_row) in LONGITUDINAL.iter().enumerate() {
        for (column, &planar_column) in LONGITUDINAL.iter().enumerate() {
            u[(planar_row, planar_column)] = longitudinal[(row, column)];
        }
    }
    u
}

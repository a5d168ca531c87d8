//! Symmetric matrices in double-double arithmetic with bounds of their rounding: what models of trees and of networks share.
#![allow(dead_code, reason = "each program takes what it needs")]

pub(crate) mod beam_matrix;
pub(crate) mod determinant;
pub(crate) mod discs;
pub(crate) mod pivots;
pub(crate) mod sparse;

use beam_matrix::Field;
use mstmm::number::{DoubleDouble, Parameter};

/// A linear form of degrees of freedom: index and factor of what is not zero.
pub(crate) type Form = Vec<(usize, DoubleDouble)>;

/// Bound of the relative error of an operation in double-double arithmetic, `2^-103`: twice that of a quotient.
pub(crate) const UNIT: f64 = 2.0 * f64::EPSILON * f64::EPSILON;

/// A symmetric matrix, and for each entry the sum of the sizes of what was added.
#[derive(Debug)]
pub(crate) struct Assembled<S> {
    pub(crate) entries: Vec<Vec<S>>,
    pub(crate) sizes: Vec<Vec<f64>>,
}

impl<S: Field> Assembled<S> {
    pub(crate) fn zero(size: usize) -> Self {
        Assembled { entries: vec![vec![S::zero(); size]; size], sizes: vec![vec![0.0; size]; size] }
    }

    /// Adds `factor · a bᵀ`, where the rounding of the factor is that of a number of a `size`.
    pub(crate) fn add(&mut self, a: &Form, b: &Form, factor: S, size: f64) {
        for &(i, a) in a {
            for &(j, b) in b {
                let product = a * b;
                self.entries[i][j] += factor * S::of(product);
                self.sizes[i][j] += size * product.to_f64().abs();
            }
        }
    }
}

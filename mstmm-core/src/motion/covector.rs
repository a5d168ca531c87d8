//! Covectors: they pick a state out of a subspace.

use crate::scalar::Scalar;

/// Picks the state `P η` out of a plane with the minors `p_ij`, `Σ_j p_ij η_j`, or `t l` out of a line.
///
/// Against the transfer direction covectors go through elements and connections by products and sums alone, while states
/// would have to be divided out of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Covector<S> {
    /// Entries for Y, Θ, M, Q, and a power of two that multiplies all.
    Plane([S; 4], i32),
    /// The factor of a line, and its power of two.
    Line(S, i32),
}

//! Lines of two-entry states, each given by one of its vectors.

use crate::number::Scalar;

/// A line of a translation or rotation path, with a power of two of its own.
///
/// In a rotation path `y` is the rotation θ and `q` is `-μ`: with this sign springs, inertias and joins obey the same
/// formulas in both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<S> {
    /// Displacement Y, or rotation Θ.
    pub y: S,
    /// Force Q, or minus the moment M.
    pub q: S,
    /// Power of two that multiplies both.
    pub exponent: i32,
}

impl<S: Scalar> Line<S> {
    /// A line through `(y, q)`.
    #[inline(always)]
    pub fn new(y: S, q: S, exponent: i32) -> Self {
        let ([y, q], shift) = S::in_range([y, q], y.size() + q.size());
        Line { y, q, exponent: exponent.saturating_add(shift) }
    }
}

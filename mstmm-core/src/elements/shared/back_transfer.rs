//! The back transfer of covectors through a beam-like element, given the functions of its transfer matrix.

use crate::number::Scalar;
use crate::subspace::Covector;

/// The transfer matrix in units in which it has neither l, EI nor β, and those units.
///
/// The functions are twice the Krylov functions `s, t, u, v` of z, divided by `2^exponent`. For small z they are series, divided by
/// 1, z, z², z³, and for the lower triangle multiplied by z⁴ (`raised`).
#[derive(Clone, Copy, Debug)]
pub struct BendingBackTransfer<S> {
    pub(crate) krylov: [S; 4],
    /// `t, u, v` of the lower triangle.
    pub(crate) raised: [S; 3],
    /// `b, EI b, EI b²` with β or `1/l` for b.
    pub(crate) factors: [S; 3],
    /// Their inverses.
    pub(crate) inverses: [S; 3],
    pub(crate) exponent: i32,
}

impl<S: Scalar> BendingBackTransfer<S> {
    /// `Uᵀ η` in units of `Y/b, Θ, M/(EI b), Q/(EI b²)`.
    pub(crate) fn back_transfer(&self, covector: Covector<S>) -> Covector<S> {
        let ([y, theta, m, q], exponent) = covector.entries();
        let BendingBackTransfer { krylov: [s, t, u, v], raised: [raised_t, raised_u, raised_v], .. } = *self;
        let (factors, inverses) = (self.factors, self.inverses);
        let (y, m, q) = (y * inverses[0], m * factors[1], q * factors[2]);
        let entries = [
            s * y + raised_v * theta + raised_u * m + raised_t * q,
            t * y + s * theta + raised_v * m + raised_u * q,
            u * y + t * theta + s * m + raised_v * q,
            v * y + u * theta + t * m + s * q,
        ];
        let entries = [entries[0] * factors[0], entries[1], entries[2] * inverses[1], entries[3] * inverses[2]];
        Covector::Plane(entries, exponent.saturating_add(self.exponent))
    }
}

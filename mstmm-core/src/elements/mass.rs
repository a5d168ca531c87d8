//! Lumped mass.

use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Translation;
use nalgebra::Matrix2;

/// Lumped mass without moment effects on a translation path.
///
/// Transfer matrix on `[Y, Q]`: `[[1, 0], [-mλ², 1]]`.
///
/// # Source
/// Eq. (5) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
}

impl<T: Real> Element for Mass<T> {
    type State = Translation;

    fn validate(&self) -> Result<(), InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Mass<T> {
    #[inline]
    fn transfer_matrix(&self, x: S) -> Matrix2<S> {
        Matrix2::new(S::one(), S::zero(), -(x.lambda_squared() * self.mass), S::one())
    }
}

#[cfg(test)]
impl super::laws::Sample for Mass<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Mass { mass: next() }
    }
}

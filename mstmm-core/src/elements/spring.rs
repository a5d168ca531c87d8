//! Translational spring.

use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Translation;
use nalgebra::Matrix2;

/// Massless translational spring, `Q = K (Y_I - Y_O)`.
///
/// Transfer matrix on `[Y, Q]`: `[[1, -1/K], [0, 1]]`.
///
/// # Source
/// Eq. (3) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring<T> {
    /// Stiffness K [N/m], positive.
    pub stiffness: T,
}

impl<T: Real> Element for Spring<T> {
    type State = Translation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Positive.check("stiffness", self.stiffness)?;
        Ok(self)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Spring<T> {
    #[inline]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix2<S> {
        let compliance = S::from_parameter(T::one() / built.stiffness);
        Matrix2::new(S::one(), -compliance, S::zero(), S::one())
    }
}

#[cfg(test)]
impl super::laws::Sample for Spring<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        Spring { stiffness: next() }
    }
}

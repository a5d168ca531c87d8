//! Torsion spring.

use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Rotation;
use nalgebra::Matrix2;

/// Massless torsion spring, `M = K (Θ_O - Θ_I)`; mind the sign, which is opposite to that of a translational spring.
///
/// Transfer matrix on `[Θ, M]`: `[[1, 1/K], [0, 1]]`.
///
/// # Source
/// Eq. (4) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionSpring<T> {
    /// Stiffness K [N m/rad], positive.
    pub stiffness: T,
}

impl<T: Real> Element for TorsionSpring<T> {
    type State = Rotation;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Positive.check("stiffness", self.stiffness)?;
        Ok(self)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for TorsionSpring<T> {
    #[inline]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix2<S> {
        let compliance = S::from_parameter(T::one() / built.stiffness);
        Matrix2::new(S::one(), compliance, S::zero(), S::one())
    }
}

#[cfg(test)]
impl super::laws::Sample for TorsionSpring<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        TorsionSpring { stiffness: next() }
    }
}

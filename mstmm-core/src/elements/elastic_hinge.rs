//! Elastic hinge in a bending path.

use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Bending;
use nalgebra::Matrix4;

/// Massless elastic hinge: a translational and a torsion spring side by side in a bending path.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `-1/K_y` at (Y, Q) and `1/K_θ` at (Θ, M).
///
/// # Source
/// Eq. (32) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElasticHinge<T> {
    /// Translational stiffness K_y [N/m], positive.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], positive.
    pub stiffness_theta: T,
}

impl<T: Real> Element for ElasticHinge<T> {
    type State = Bending;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Positive.check("stiffness_y", self.stiffness_y)?;
        Requirement::Positive.check("stiffness_theta", self.stiffness_theta)?;
        Ok(self)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for ElasticHinge<T> {
    #[inline]
    fn transfer_matrix(built: &Self, _x: S) -> Matrix4<S> {
        let mut u = Matrix4::identity();
        u[(0, 3)] = -S::from_parameter(T::one() / built.stiffness_y);
        u[(1, 2)] = S::from_parameter(T::one() / built.stiffness_theta);
        u
    }
}

#[cfg(test)]
impl super::laws::Sample for ElasticHinge<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        ElasticHinge { stiffness_y: next(), stiffness_theta: next() }
    }
}

//! Elastic hinge in planar motion.

use crate::element::{Element, TransferMatrix};
use crate::elements::shared::compliance::compliance;
use crate::model::{InvalidParameter, Planar, Requirement};
use crate::number::{Frequency, Parameter, Single};
use nalgebra::Matrix6;

/// Massless elastic hinge in planar motion: three springs side by side.
///
/// Transfer matrix on `[X, Y, Θ, M, Qx, Qy]`: the identity plus `-1/K_x` at (X, Qx), `-1/K_y` at (Y, Qy) and `1/K_θ` at
/// (Θ, M).
///
/// # Source
/// Eqs. (3), (4) and (32) of the paper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanarHinge<T> {
    /// Stiffness K_x along x [N/m], positive, with a finite reciprocal; infinite is rigid.
    pub stiffness_x: T,
    /// Stiffness K_y along y [N/m], positive, with a finite reciprocal; infinite is rigid.
    pub stiffness_y: T,
    /// Torsional stiffness K_θ [N m/rad], positive, with a finite reciprocal; infinite is rigid.
    pub stiffness_theta: T,
}

impl<T: Parameter> Element for PlanarHinge<T> {
    type State = Planar;
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::InvertibleOrInfinite.check("stiffness_x", self.stiffness_x)?;
        Requirement::InvertibleOrInfinite.check("stiffness_y", self.stiffness_y)?;
        Requirement::InvertibleOrInfinite.check("stiffness_theta", self.stiffness_theta)?;
        Ok(self)
    }
}

impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for PlanarHinge<T> {
    fn transfer_matrix(built: &Self, _x: S) -> Matrix6<S> {
        let stiffness = [built.stiffness_x, built.stiffness_y, built.stiffness_theta];
        hinge_matrix(stiffness.map(|stiffness| S::from_parameter(compliance(stiffness))))
    }
}

/// The transfer matrix of a hinge from its compliances along x, along y and about z.
#[inline(always)]
pub(crate) fn hinge_matrix<S: Single>([x, y, rotation]: [S; 3]) -> Matrix6<S> {
    let mut u = Matrix6::identity();
    (u[(0, 4)], u[(1, 5)], u[(2, 3)]) = (-x, -y, rotation);
    u
}

#[cfg(test)]
impl super::laws::Sample for PlanarHinge<f64> {
    /// By compliances: an infinite one is no hinge, an infinite stiffness is rigid.
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        let [stiffness_x, stiffness_y, stiffness_theta] = [(); 3].map(|()| 1.0 / next());
        PlanarHinge { stiffness_x, stiffness_y, stiffness_theta }
    }
}

//! Lumped mass inside a bending path.

use crate::element::{Element, TransferMatrix};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{Frequency, Real};
use crate::state::Bending;
use nalgebra::Matrix4;

/// Lumped mass with rotary inertia inside a bending path: a rigid body of no length.
///
/// Transfer matrix on `[Y, Θ, M, Q]`: the identity plus `Jλ²` at (M, Θ) and `-mλ²` at (Q, Y).
///
/// # Source
/// Eq. (16) of the paper with `b = c = 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointMass<T> {
    /// Mass m \[kg\], zero or positive.
    pub mass: T,
    /// Moment of inertia J [kg m²], zero or positive.
    pub inertia: T,
}

impl<T: Real> Element for PointMass<T> {
    type State = Bending;

    fn validate(&self) -> Result<(), InvalidParameter> {
        Requirement::NonNegative.check("mass", self.mass)?;
        Requirement::NonNegative.check("inertia", self.inertia)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for PointMass<T> {
    #[inline]
    fn transfer_matrix(&self, x: S) -> Matrix4<S> {
        let mut u = Matrix4::identity();
        u[(2, 1)] = x.lambda_squared() * self.inertia;
        u[(3, 0)] = -(x.lambda_squared() * self.mass);
        u
    }
}

#[cfg(test)]
impl super::laws::Sample for PointMass<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        PointMass { mass: next(), inertia: next() }
    }
}

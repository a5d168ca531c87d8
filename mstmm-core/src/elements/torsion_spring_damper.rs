//! Torsion spring and torsion damper in parallel.

use crate::element::{Element, TransferMatrix, off_pole};
use crate::error::{InvalidParameter, Requirement};
use crate::scalar::{ComplexFrequency, Real};
use crate::state::Rotation;
use nalgebra::Matrix2;

/// Massless torsion spring and viscous torsion damper in parallel, `M = (K + Cλ)(Θ_O - Θ_I)`.
///
/// Transfer matrix on `[Θ, M]`: `[[1, 1/κ], [0, 1]]` with the dynamic stiffness `κ = K + Cλ`, whose zero is the
/// element's [`denominator`](TransferMatrix::denominator). It exists at complex frequencies λ only.
///
/// # Source
/// Eq. (39) of the paper, on rotations as in eq. (4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorsionSpringDamper<T> {
    /// Stiffness K [N m/rad], positive.
    pub stiffness: T,
    /// Damping C [N m s/rad], zero or positive.
    pub damping: T,
}

impl<T: Real> Element for TorsionSpringDamper<T> {
    type State = Rotation;

    fn validate(&self) -> Result<(), InvalidParameter> {
        Requirement::Positive.check("stiffness", self.stiffness)?;
        Requirement::NonNegative.check("damping", self.damping)
    }
}

impl<T: Real, S: ComplexFrequency<T>> TransferMatrix<S> for TorsionSpringDamper<T> {
    #[inline]
    fn transfer_matrix(&self, x: S) -> Matrix2<S> {
        let compliance = S::one() / off_pole(self.dynamic_stiffness(x));
        Matrix2::new(S::one(), compliance, S::zero(), S::one())
    }

    #[inline]
    fn denominator(&self, x: S) -> Option<S> {
        Some(off_pole(self.dynamic_stiffness(x)))
    }
}

impl<T: Real> TorsionSpringDamper<T> {
    /// `κ = K + Cλ`.
    #[inline]
    fn dynamic_stiffness<S: ComplexFrequency<T>>(&self, x: S) -> S {
        S::from_parameter(self.stiffness) + x * self.damping
    }
}

#[cfg(test)]
impl super::laws::Sample for TorsionSpringDamper<f64> {
    fn sample(mut next: impl FnMut() -> f64) -> Self {
        TorsionSpringDamper { stiffness: next(), damping: next() }
    }
}

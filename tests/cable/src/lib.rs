//! An element of one's own, in a crate of its own: a string in tension.
#![no_std]

use mstmm::{Element, Frequency, InvalidParameter, Real, Requirement, SMatrix, TransferMatrix, Translation};

/// A uniform string in tension, exact at every frequency.
///
/// Transfer matrix on `[Y, Q]` with `φ = ω l sqrt(m/H)`:
///
/// ```text
/// cos φ           -(l/H) sin φ/φ
/// (H/l) φ sin φ    cos φ
/// ```
///
/// The wave equation `H Y'' = mλ² Y` with the transverse force `Q = -H Y'` in the sign convention of a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cable<T> {
    /// Length l \[m\], positive.
    pub length: T,
    /// Tension H \[N\], positive.
    pub tension: T,
    /// Mass per length m [kg/m], positive.
    pub mass_per_length: T,
}

impl<T: Real> Element for Cable<T> {
    type State = Translation;

    fn validate(&self) -> Result<(), InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("tension", self.tension)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Cable<T> {
    fn transfer_matrix(&self, x: S) -> SMatrix<S, 2, 2> {
        let phi_squared = -x.lambda_squared() * (self.mass_per_length / self.tension * self.length * self.length);
        let phi = phi_squared.sqrt();
        let (sin, cos) = phi.sin_cos();
        let sinc = if phi.is_zero() { S::one() } else { sin / phi };
        let flexibility = self.length / self.tension;
        SMatrix::<S, 2, 2>::new(cos, -(sinc * flexibility), phi * sin * (T::one() / flexibility), cos)
    }
}

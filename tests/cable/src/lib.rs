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
    type Built = Self;

    fn build(self) -> Result<Self, InvalidParameter> {
        Requirement::Positive.check("length", self.length)?;
        Requirement::Positive.check("tension", self.tension)?;
        Requirement::Positive.check("mass_per_length", self.mass_per_length)?;
        Ok(self)
    }
}

impl<T: Real, S: Frequency<T>> TransferMatrix<S> for Cable<T> {
    fn transfer_matrix(cable: &Self, x: S) -> SMatrix<S, 2, 2> {
        let phi_squared = -x.lambda_squared() * (cable.mass_per_length / cable.tension * cable.length * cable.length);
        let phi = phi_squared.sqrt();
        let (sin, cos) = phi.sin_cos();
        let sinc = if phi.is_zero() { S::one() } else { sin / phi };
        let flexibility = cable.length / cable.tension;
        SMatrix::<S, 2, 2>::new(cos, -(sinc * flexibility), phi * sin * (T::one() / flexibility), cos)
    }
}

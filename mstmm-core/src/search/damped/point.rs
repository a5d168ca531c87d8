//! Points of the complex plane at which Δ is known.

use crate::number::{Real, Scaled};
use num_complex::Complex;

/// A point with Δ, or with the rest of Δ when roots and growth are divided out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    pub(super) lambda: Complex<T>,
    pub(super) value: Scaled<Complex<T>>,
    /// `Δ'/Δ`.
    pub(super) rate: Complex<T>,
    /// Whether Δ vanishes, or so nearly that its inverse overflows.
    pub(super) is_root: bool,
}

impl<T: Real> Point<T> {
    /// Δ'.
    pub(super) fn slope(&self) -> Scaled<Complex<T>> {
        self.value.times(self.rate)
    }

    /// The mirror image on the other side of the real axis.
    pub(super) fn mirrored(&self) -> Self {
        let value = Scaled::new(self.value.mantissa().conj(), self.value.exponent());
        Point { lambda: self.lambda.conj(), value, rate: self.rate.conj(), is_root: self.is_root }
    }
}

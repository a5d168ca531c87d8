//! Roots of all kinds, as questions about motions take them.

use crate::model::motion_error::MotionError;
use crate::number::frequency::Oscillation;
use crate::number::frequency::Real;
use crate::search::damped::found::Eigenvalue;
use crate::search::undamped::found::NaturalFrequency;
use num_complex::Complex;

/// A root of Δ: a natural frequency or an eigenvalue.
pub trait Root<T: Real> {
    /// The frequency at which the system is evaluated there: a real ω, or a complex λ.
    type Frequency: Oscillation<T>;

    /// That frequency.
    fn frequency(&self) -> Self::Frequency;

    /// Number of coinciding roots.
    fn multiplicity(&self) -> u64;

    /// Where the root shows in a response, ω [rad/s], and half the width of its resonance at half the power; zero where it has
    /// none, or none that can be told from rounding.
    fn peak(&self) -> (T, T);
}

impl<T: Real> Root<T> for NaturalFrequency<T> {
    type Frequency = T;

    fn frequency(&self) -> T {
        self.omega
    }

    fn peak(&self) -> (T, T) {
        (self.omega, T::zero())
    }

    fn multiplicity(&self) -> u64 {
        self.multiplicity
    }
}

impl<T: Real> Root<T> for Eigenvalue<T> {
    type Frequency = Complex<T>;

    fn frequency(&self) -> Complex<T> {
        self.lambda
    }

    fn peak(&self) -> (T, T) {
        // what decays no faster than the root is known does not decay as far as anyone can tell
        let width = self.lambda.re.abs();
        let is_known = width > self.error;
        (self.lambda.im.abs(), if is_known { width } else { T::zero() })
    }

    fn multiplicity(&self) -> u64 {
        self.multiplicity
    }
}

/// The frequency of a simple root.
pub(crate) fn simple_root<T: Real, R: Root<T>>(root: &R) -> Result<R::Frequency, MotionError> {
    let (frequency, multiplicity) = (root.frequency(), root.multiplicity());
    if multiplicity > 1 {
        return Err(MotionError::Multiple { root: frequency.modulus(), multiplicity });
    }
    Ok(frequency)
}

//! The roots that questions about motions take: natural frequencies and eigenvalues.

use crate::model::MotionError;
use crate::number::{Oscillation, Real, Scalar, larger};
use crate::pass::characteristic::System;
use crate::search::damped::found::Eigenvalue;
use crate::search::undamped::found::NaturalFrequency;
use num_complex::Complex;
use num_traits::Zero;

/// A root of Δ: a natural frequency or an eigenvalue.
pub trait Root<T: Real> {
    /// The frequency at which the system is evaluated there: a real ω, or a complex λ.
    type Frequency: Oscillation<T>;

    /// The root itself.
    fn frequency(&self) -> Self::Frequency;

    /// Number of coinciding roots.
    fn multiplicity(&self) -> u64;

    /// The frequency ω [rad/s] of its resonance, and half the width of the resonance at half the power. The width is zero for an
    /// undamped root, or one that is undamped to rounding.
    fn peak(&self) -> (T, T);

    /// The root as an eigenvalue, with a circle that holds it: at rest a natural frequency is two.
    #[doc(hidden)]
    fn eigenvalue(&self) -> Eigenvalue<T>;
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

    fn eigenvalue(&self) -> Eigenvalue<T> {
        let multiplicity = if self.omega.is_zero() { 2 * self.multiplicity } else { self.multiplicity };
        let lambda = Complex::new(T::zero(), self.omega);
        let error = larger(self.upper - self.omega, self.omega - self.lower);
        Eigenvalue { lambda, error, multiplicity, is_proven: false }
    }
}

impl<T: Real> Root<T> for Eigenvalue<T> {
    type Frequency = Complex<T>;

    fn frequency(&self) -> Complex<T> {
        self.lambda
    }

    fn peak(&self) -> (T, T) {
        // a decay slower than the uncertainty of the root counts as none
        let width = self.lambda.re.abs();
        let is_known = width > self.error;
        (self.lambda.im.abs(), if is_known { width } else { T::zero() })
    }

    fn eigenvalue(&self) -> Eigenvalue<T> {
        *self
    }

    fn multiplicity(&self) -> u64 {
        self.multiplicity
    }
}

/// Whether a frequency is below the real axis of λ in a system with a loss factor: motions have the conjugate one there, and Δ, which goes on
/// from above, is not theirs.
pub(crate) fn is_below_losses<Y, S>(system: &Y, x: S) -> bool
where
    Y: System + ?Sized,
    S: Oscillation<Y::Parameter>,
{
    x.to_complex().im < Y::Parameter::zero() && system.frequency_estimates().has_loss()
}

/// Refuses rest to rotors: about it their poles are of several orders, and motions there have no modal mass.
pub(crate) fn check_at_rest<Y: System + ?Sized, S: Scalar>(_system: &Y, x: S) -> Result<(), MotionError> {
    if const { Y::SPINS } && x.is_zero() { Err(MotionError::ZeroFrequency) } else { Ok(()) }
}

/// The frequency of a simple root.
pub(crate) fn simple_root<T: Real, R: Root<T>>(root: &R) -> Result<R::Frequency, MotionError> {
    let (frequency, multiplicity) = (root.frequency(), root.multiplicity());
    if multiplicity > 1 {
        return Err(MotionError::Multiple { root: frequency.modulus(), multiplicity });
    }
    Ok(frequency)
}

/// What a root moves by where the dynamic work of its shape grows by 1: `dλ/dp = -(∂L/∂p)/(∂L/∂λ)`, where `∂L/∂λ = (dλ²/dλ)/2` for a shape of unit modal
/// mass.
pub(crate) fn moved_by_work<T: Real, S: Oscillation<T>>(x: S) -> S {
    let two = S::one() + S::one();
    -two / x.slope_of_lambda_squared()
}

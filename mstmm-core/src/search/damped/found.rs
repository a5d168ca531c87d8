//! Regions of the complex plane, and eigenvalues that were found in them.

use crate::model::turns;
use crate::number::{Frequency, List, Real, modulus};
use core::ops::{Deref, RangeInclusive};
use num_complex::Complex;

/// A closed rectangle of the complex plane of λ [1/s].
#[derive(Clone, Debug, PartialEq)]
pub struct Region<T = f64> {
    /// Range of the real part [1/s]; that of damped motions is negative.
    pub re: RangeInclusive<T>,
    /// Range of the imaginary part, the angular frequency of the damped motion [rad/s].
    pub im: RangeInclusive<T>,
}

impl<T: Real> Region<T> {
    /// The region in numbers of another type.
    pub(crate) fn map<U>(self, number: impl Fn(T) -> U) -> Region<U> {
        let range = |range: RangeInclusive<T>| number(*range.start())..=number(*range.end());
        Region { re: range(self.re), im: range(self.im) }
    }
}

/// A number in extended precision.
pub(super) fn exactly<T: Real>(number: T) -> T::Extended {
    <T::Extended as Frequency<T>>::from_parameter(number)
}

/// An eigenvalue λ of a system, proven or counted by the argument principle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Eigenvalue<T = f64> {
    /// The eigenvalue [1/s].
    pub lambda: Complex<T>,
    /// Radius [1/s] of a circle around λ that holds the root. Where it is not proven, the argument of Δ turns once for each of its roots along
    /// the circle of half this radius, or for a simple root Δ and Δ' at two opposite points show one root near its centre.
    pub error: T,
    /// Number of eigenvalues in that circle.
    pub multiplicity: u64,
    /// Whether it is a theorem that the disc `|z - lambda| <= error` holds exactly one eigenvalue, with all rounding in its proof.
    ///
    /// Those of several eigenvalues are not proven, nor are systems with an element that is not known in numbers: a tapered beam, or one of the
    /// user's own. Without the feature `proof` nothing is. That a list has all eigenvalues of a region is counted.
    pub is_proven: bool,
}

impl<T: Real> Eigenvalue<T> {
    /// Its mirror image on the other side of the real axis.
    pub(super) fn image(&self) -> Self {
        Eigenvalue { lambda: self.lambda.conj(), ..*self }
    }

    /// Angular frequency of the undamped motion, `|λ|` [rad/s]; that of the damped motion is `lambda.im`.
    pub fn frequency(&self) -> T {
        modulus(self.lambda)
    }

    /// Frequency `|Im λ|/2π` in hertz of the damped motion; 0 where λ is real and the motion does not oscillate.
    ///
    /// ```
    /// use mstmm_core::{Complex, search::Eigenvalue};
    ///
    /// let root = Eigenvalue { lambda: Complex::new(-0.3, std::f64::consts::TAU * 25.0), ..Eigenvalue::default() };
    /// assert_eq!((root.hertz(), root.rpm().round(), root.period()), (25.0, 1500.0, 0.04));
    /// ```
    pub fn hertz(&self) -> T {
        turns::in_hertz(self.lambda.im.abs())
    }

    /// Speed of a shaft `30 |Im λ|/π` [1/min] that turns once in a period.
    pub fn rpm(&self) -> T {
        turns::rpm(self.lambda.im.abs())
    }

    /// Period `2π/|Im λ|` \[s\] of the damped motion; infinite where λ is real and the motion does not oscillate.
    pub fn period(&self) -> T {
        turns::period(self.lambda.im.abs())
    }

    /// Damping ratio `-Re λ/|λ|`: 0 undamped, 1 critical (λ real); 0 for λ = 0.
    pub fn damping_ratio(&self) -> T {
        let modulus = self.frequency();
        if modulus.is_zero() { modulus } else { -self.lambda.re / modulus }
    }

    /// Logarithmic decrement `-2π Re λ/|Im λ|`: the natural logarithm of the ratio of two amplitudes one period apart. 0
    /// undamped, infinite where λ is real and the motion does not oscillate; 0 for λ = 0.
    pub fn logarithmic_decrement(&self) -> T {
        if self.lambda.re.is_zero() {
            return T::zero();
        }
        -(self.lambda.re * T::from_f64(core::f64::consts::TAU)) / self.lambda.im.abs()
    }

    /// Time `-1/Re λ` \[s\] in which the amplitude falls to 1/e; infinite for an undamped motion.
    pub fn decay_time(&self) -> T {
        // not -0, whose inverse is negative
        if self.lambda.re.is_zero() { T::one() / T::zero() } else { -T::one() / self.lambda.re }
    }
}

/// What a search found, and the number of evaluations that it took.
pub(super) struct Found<L> {
    pub(super) eigenvalues: L,
    pub(super) evaluations: usize,
}

/// Eigenvalues and the number of evaluations they took; dereferences to a slice.
///
/// An evaluation is one pass; each pass of these searches also gives the derivative and counts as two.
#[derive(Clone, Copy, Debug)]
pub struct EigenvalueList<T: Real, const CAP: usize> {
    pub(super) eigenvalues: List<Eigenvalue<T>, CAP>,
    pub(super) evaluations: usize,
}

impl<T: Real, const CAP: usize> From<Found<List<Eigenvalue<T>, CAP>>> for EigenvalueList<T, CAP> {
    fn from(found: Found<List<Eigenvalue<T>, CAP>>) -> Self {
        EigenvalueList { eigenvalues: found.eigenvalues, evaluations: found.evaluations }
    }
}

impl<T: Real, const CAP: usize> EigenvalueList<T, CAP> {
    /// Number of evaluations.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }
}

impl<T: Real, const CAP: usize> Deref for EigenvalueList<T, CAP> {
    type Target = [Eigenvalue<T>];

    fn deref(&self) -> &[Eigenvalue<T>] {
        &self.eigenvalues
    }
}

impl<'a, T: Real, const CAP: usize> IntoIterator for &'a EigenvalueList<T, CAP> {
    type Item = &'a Eigenvalue<T>;
    type IntoIter = core::slice::Iter<'a, Eigenvalue<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

//! When a result is doubtful: all limits beyond which rounding may have had a hand in it.
//!
//! Sums that cancel are watched by the pass itself, roots that touch by the searches, states that do not fit by the motions.
//! What is doubtful is computed again in the arithmetic that judges the first, or refused where there is none.

use crate::number::frequency::Real;
use crate::number::scalar::Scalar;

/// Relative loss of a sum beyond which a pass is doubtful, in units of rounding: as wide as a certified interval.
const LOSS: f64 = 32.0;

/// Roundings that the terms of a sum carry: what is left of them below so many is rounding alone, and taken for zero.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// Condition of a root beyond which its interval is proven by the judge: by how much the terms of Δ together exceed its growth over
/// the whole frequency.
pub(crate) const CONDITION: f64 = 4.0;

/// Distance from a root, in units of rounding, at which its counts are taken and its circle is looked at.
pub(crate) const NEAR: f64 = 8.0;

/// Difference between what two points on a circle make of the root in it, as a part of the radius, beyond which the judge has to
/// prove it.
pub(crate) const NOISE: f64 = 0.2;

/// How many times as wide as others the interval or circle of an ill-conditioned root is where nothing judges it.
pub(crate) const UNPROVEN_WIDTH: f64 = 8.0;

/// Whether what looks like rounding is refused, since no arithmetic has the digits to judge it.
pub(crate) fn refuses_doubt<T: Real>() -> bool {
    !T::HAS_EXTENDED && T::EPSILON == f64::EPSILON
}

/// Whether an arithmetic judges that of a system's parameters.
pub(crate) fn is_extended<T: Real, P: Real>() -> bool {
    T::EPSILON < P::EPSILON
}

/// Whether no other arithmetic judges what this one makes of a system.
pub(crate) fn is_last<T: Real, P: Real>() -> bool {
    is_extended::<T, P>() || refuses_doubt::<T>()
}

/// Whether Δ beside a root is less beside its terms than that of a well-conditioned root.
#[inline(always)]
pub(crate) fn is_ill_conditioned<S: Scalar>(sum: f64, terms: f64) -> bool {
    sum * CONDITION < NEAR * S::EPSILON * terms
}

/// Relative distance of roots below which rounding may have made two of one of multiplicity 2 or 3.
pub(crate) const TOUCHING: f64 = 1e-5;

/// Radius of the circle around an eigenvalue, in units of rounding of its modulus, beyond which rounding has widened it.
pub(crate) const USUAL_ERROR: f64 = 20.0;

/// Factor below the lowest estimate of a frequency, as a power of two, at which rounding may have made a frequency of a zero.
pub(crate) const NEARLY_ZERO_EXPONENT: i32 = 20;

/// Least and largest growth of Δ across a root, by its slope beside it, that rounding leaves alone.
pub(crate) const BRANCH_FREE: (f64, f64) = (0.5, 2.0);

/// Misfit of the states of a motion, in units of rounding, from which on it is computed again in the arithmetic that judges it.
pub(crate) const MISFIT: f64 = 1e3;

/// Misfit, in units of rounding, with which a motion is not returned.
pub(crate) const REFUSED_MISFIT: f64 = 5e6;

/// Relative loss of a sum that a certificate has room for: that of the arithmetic, or of the one that it judges.
#[inline(always)]
pub(crate) fn largest_loss<S: Scalar>() -> f64 {
    LOSS * if S::EPSILON < f64::EPSILON { f64::EPSILON } else { S::EPSILON }
}

/// Whether a sum may have lost more than it should to rounding: a first look, which asks for a closer one.
#[inline(always)]
pub(crate) fn may_be_lost<S: Scalar>(terms: f64, sum: S) -> bool {
    S::EPSILON * terms > largest_loss::<S>() * sum.size()
}

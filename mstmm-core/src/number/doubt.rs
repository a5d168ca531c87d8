//! Limits beyond which rounding makes a result doubtful.
//!
//! Searches for eigenvalues watch for sums that cancel and for circles that are wide. Shapes and responses watch for states that do not fit.
//! A doubtful result is computed again in extended precision, or refused where there is none. Natural frequencies are proven instead.

use crate::number::frequency::Real;
use crate::number::scalar::Scalar;
use crate::number::truth::Size;

/// Relative loss of a sum beyond which a pass is doubtful, in units of rounding: as wide as a certified circle.
const LOSS: f64 = 32.0;

/// Number of roundings that the terms of a sum carry. A sum below that is rounding alone, and taken for zero.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// Condition of an eigenvalue beyond which extended precision proves its circle: how much its neighbours magnify rounding.
pub(crate) const CONDITION: f64 = 4.0;

/// Difference between the roots that two points on a circle predict, as a part of the radius, beyond which extended precision has
/// to prove the root.
pub(crate) const NOISE: f64 = 0.2;

/// Factor on the width of the circle of an eigenvalue where no extended precision proves it.
pub(crate) const UNPROVEN_WIDTH: f64 = 8.0;

/// Whether doubtful results are refused, since there is no extended precision.
fn refuses_doubt<T: Real>() -> bool {
    !T::HAS_EXTENDED && T::EPSILON == f64::EPSILON
}

/// Whether `T` is extended precision for parameters of type `P`.
pub(crate) fn is_extended<T: Real, P: Real>() -> bool {
    T::EPSILON < P::EPSILON
}

/// Whether a result of type `T` has no further precision to be computed in, for parameters of type `P`.
pub(crate) fn is_last<T: Real, P: Real>() -> bool {
    is_extended::<T, P>() || refuses_doubt::<T>()
}

/// Radius of the circle around an eigenvalue, in units of rounding of its modulus, beyond which rounding has widened it.
pub(crate) const USUAL_ERROR: f64 = 20.0;

/// Misfit of the states of a motion, in units of rounding, from which on the motion is computed again in extended precision.
pub(crate) const MISFIT: f64 = 1e3;

/// Misfit, in units of rounding, with which a motion is not returned.
pub(crate) const REFUSED_MISFIT: f64 = 5e6;

/// Relative loss of a sum for which a circle has room; in extended precision that of `f64`.
#[inline(always)]
pub(crate) fn largest_loss<S: Scalar>() -> f64 {
    LOSS * if S::EPSILON < f64::EPSILON { f64::EPSILON } else { S::EPSILON }
}

/// Whether a sum may have lost too much to rounding: a first test, to be confirmed by a closer one.
#[inline(always)]
pub(crate) fn may_be_lost<S: Scalar>(terms: S::Size, sum: S) -> S::Truth {
    (sum.size() * S::Size::of(largest_loss::<S>())).is_below(terms * S::Size::of(S::EPSILON))
}

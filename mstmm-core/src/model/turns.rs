//! Angular frequencies in turns: hertz, turns per minute, periods.

use crate::number::Real;
use core::f64::consts::{FRAC_1_PI, TAU};

/// The angular frequency `2π f` \[rad/s\] of a frequency f in hertz, for searches, ranges and responses.
///
/// ```
/// use mstmm_core::hertz;
///
/// let range = hertz(1.0)..=hertz(200.0);
/// assert_eq!(*range.start(), std::f64::consts::TAU);
/// ```
#[inline]
pub fn hertz<T: Real>(frequency: T) -> T {
    frequency * T::from_f64(TAU)
}

/// ω/2π in hertz.
#[inline]
pub(crate) fn in_hertz<T: Real>(omega: T) -> T {
    omega * T::from_f64(TAU.recip())
}

/// 30 ω/π [1/min].
#[inline]
pub(crate) fn rpm<T: Real>(omega: T) -> T {
    omega * T::from_f64(30.0 * FRAC_1_PI)
}

/// 2π/ω \[s\], infinite at rest.
#[inline]
pub(crate) fn period<T: Real>(omega: T) -> T {
    if omega.is_zero() { T::from_f64(f64::INFINITY) } else { T::from_f64(TAU) / omega }
}

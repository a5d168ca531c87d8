//! Numbers with an exponent of their own: determinants that neither overflow nor vanish.

use crate::number::frequency::Real;
use crate::number::scalar::{Scalar, Single};
use crate::number::truth::Size;
use core::cmp::Ordering;
use core::fmt;
use num_complex::Complex;

/// `mantissa · 2^exponent`.
///
/// Invariant: the larger component of a finite, non-zero mantissa lies in `[1, 2)`; zero and non-finite values have
/// exponent 0. Exponents stop at the ends of the range of `i64`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaled<S> {
    mantissa: S,
    exponent: i64,
}

impl<S: Scalar> Scaled<S> {
    /// `value · 2^exponent`, normalised; numbers in lanes have no exponents of their own and stay as they are.
    #[inline]
    pub fn new(value: S, exponent: i64) -> Self {
        if S::IN_LANES {
            return Scaled { mantissa: value, exponent };
        }
        match value.size().exponent() {
            Some(shift) => Scaled {
                mantissa: value.times_power_of_two(-shift),
                exponent: exponent.saturating_add(i64::from(shift)),
            },
            None => Scaled { mantissa: value, exponent: 0 },
        }
    }

    /// The number over `2^exponent`; infinite or zero where it leaves the range of the type.
    #[inline(always)]
    pub(crate) fn over_power(self, exponent: i64) -> S {
        // numbers in lanes have all the same power of two
        match self.exponent.saturating_sub(exponent) {
            0 => self.mantissa,
            shift => self.mantissa.times_power_of_two(shift.clamp(-3000, 3000) as i32),
        }
    }

    /// The factor in `[1, 2)` (or zero, or not finite).
    #[inline]
    pub fn mantissa(self) -> S {
        self.mantissa
    }

    /// The power of two.
    #[inline]
    pub fn exponent(self) -> i64 {
        self.exponent
    }

    /// The product with another scaled number.
    #[inline]
    pub(crate) fn product(self, factor: Scaled<S>) -> Self {
        Scaled::new(self.mantissa * factor.mantissa, self.exponent.saturating_add(factor.exponent))
    }

    /// The product with a plain number.
    #[must_use]
    #[inline]
    pub fn times(self, factor: S) -> Self {
        self.product(Scaled::new(factor, 0))
    }

    /// The quotient by another scaled number.
    #[inline]
    pub(crate) fn over(self, divisor: Scaled<S>) -> Self {
        Scaled::new(self.mantissa / divisor.mantissa, self.exponent.saturating_sub(divisor.exponent))
    }
}

impl<S: Single> Scaled<S> {
    /// The [`size`](Scalar::size) of the mantissa, with the exponent.
    #[inline]
    pub(crate) fn magnitude(self) -> Magnitude {
        Scaled::new(self.mantissa.size(), self.exponent).into()
    }

    /// The plain number; infinite or zero where it leaves the range of the type.
    #[inline]
    pub fn value(self) -> S {
        let exponent = self.exponent.clamp(-5000, 5000);
        self.mantissa.times_power_of_two(exponent as i32)
    }
}

/// A modulus with an exponent of its own: what the searches for minima compare and report.
///
/// Ordered like the real numbers that it stands for; a NaN compares with nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Magnitude {
    mantissa: f64,
    exponent: i64,
}

impl Magnitude {
    /// The plain number; infinite or zero where it leaves the range of `f64`.
    #[inline]
    pub fn value(self) -> f64 {
        Scaled { mantissa: self.mantissa, exponent: self.exponent }.value()
    }

    /// `own² / (before · after)` of three equally spaced samples: less than 1 where their logarithm is convex. A factor
    /// `e^{az}` of the function does not change it.
    #[inline]
    pub(crate) fn concavity(before: Magnitude, own: Magnitude, after: Magnitude) -> Magnitude {
        let ratio = own.mantissa * own.mantissa / (before.mantissa * after.mantissa);
        let exponents = own.exponent.saturating_mul(2).saturating_sub(before.exponent.saturating_add(after.exponent));
        Scaled::new(ratio, exponents).into()
    }

    /// Whether the logarithm of three equally spaced samples is convex; that of equal samples is not.
    ///
    /// The logarithm of a pole-free |Δ| is concave along ω between roots (undamped), and harmonic in λ, so not convex
    /// along two axes at once, away from roots (damped): convex samples have a root between them.
    #[inline]
    pub(crate) fn is_log_convex(before: Magnitude, own: Magnitude, after: Magnitude) -> bool {
        Self::concavity(before, own, after) < Magnitude::from(1.0)
    }

    /// Whether this is exactly zero.
    #[inline]
    pub(crate) fn is_zero(self) -> bool {
        self.mantissa == 0.0
    }

    /// Whether this is not a number.
    #[inline]
    pub fn is_nan(self) -> bool {
        self.mantissa.is_nan()
    }
}

impl PartialOrd for Magnitude {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        let ordinary = |m: f64| m != 0.0 && m.is_finite();
        if ordinary(self.mantissa) && ordinary(other.mantissa) && self.exponent != other.exponent {
            return self.exponent.partial_cmp(&other.exponent);
        }
        self.mantissa.partial_cmp(&other.mantissa)
    }
}

impl fmt::Display for Magnitude {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.exponent.unsigned_abs() < 1000 {
            return write!(f, "{:e}", self.value());
        }
        write!(f, "{} * 2^{}", self.mantissa, self.exponent)
    }
}

impl From<f64> for Magnitude {
    #[inline]
    fn from(value: f64) -> Self {
        Scaled::new(value, 0).into()
    }
}

impl<T: Real> From<Complex<T>> for Magnitude {
    #[inline]
    fn from(value: Complex<T>) -> Self {
        Scaled::new(value, 0).into()
    }
}

impl From<Scaled<f64>> for Magnitude {
    #[inline]
    fn from(value: Scaled<f64>) -> Self {
        Magnitude { mantissa: value.mantissa.abs(), exponent: value.exponent }
    }
}

impl<T: Real> From<Scaled<Complex<T>>> for Magnitude {
    #[inline]
    fn from(value: Scaled<Complex<T>>) -> Self {
        let Complex { re, im } = value.mantissa;
        let modulus = Scaled::new((re * re + im * im).sqrt().to_f64(), value.exponent);
        Magnitude { mantissa: modulus.mantissa, exponent: modulus.exponent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::string::ToString;

    proptest! {
        #[test]
        fn order_is_that_of_the_numbers(a in proptest::num::f64::ANY, b in proptest::num::f64::ANY) {
            prop_assert_eq!(Magnitude::from(a).partial_cmp(&Magnitude::from(b)), a.abs().partial_cmp(&b.abs()));
        }

        #[test]
        fn value_returns_what_went_in(a in proptest::num::f64::ANY) {
            prop_assert_eq!(Scaled::new(a, 0).value().to_bits(), a.to_bits());
        }

        #[test]
        fn mantissa_is_normalised(a in proptest::num::f64::NORMAL | proptest::num::f64::SUBNORMAL) {
            prop_assert!((1.0..2.0).contains(&Scaled::new(a, 0).mantissa().abs()));
        }
    }

    #[test]
    fn the_ends_of_the_range_are_normalised() {
        for (value, exponent) in [(f64::MAX, 1023), (f64::MIN_POSITIVE, -1022), (5e-324, -1074)] {
            let scaled = Scaled::new(-value, 0);
            assert!((1.0..2.0).contains(&-scaled.mantissa()), "{scaled:?}");
            assert_eq!(scaled.exponent(), exponent);
        }
    }

    #[test]
    fn products_neither_overflow_nor_vanish() {
        let huge = Scaled::new(1e300, 0).times(1e300).times(1e300);
        let back = huge.times(1e-300).times(1e-300);
        assert!(f64::abs(back.value() / 1e300 - 1.0) < 8.0 * f64::EPSILON);
        assert_eq!(huge.value(), f64::INFINITY);
        assert!(Magnitude::from(huge) > Magnitude::from(1e300));
        assert!(Magnitude::from(0.0) < Magnitude::from(Scaled::new(1e-300, -10_000)));
    }
    #[test]
    fn exponents_stop_at_the_ends_of_their_range() {
        let largest = Scaled::new(2.0, i64::MAX);
        assert_eq!((largest.exponent(), largest.times(8.0).exponent()), (i64::MAX, i64::MAX));
        let smallest = Scaled::new(0.5, i64::MIN);
        assert_eq!((smallest.exponent(), smallest.times(0.25).exponent()), (i64::MIN, i64::MIN));
        assert_eq!(Magnitude::from(smallest).to_string(), std::format!("1 * 2^{}", i64::MIN));
        let (smallest, largest) = (smallest.into(), largest.into());
        assert!(Magnitude::is_log_convex(largest, smallest, largest));
        assert!(!Magnitude::is_log_convex(smallest, largest, smallest));
    }

    #[test]
    fn equal_samples_are_not_convex() {
        for value in [0.0, 1.0, 1.3e-200] {
            let value = Magnitude::from(value);
            assert!(!Magnitude::is_log_convex(value, value, value));
        }
    }
}

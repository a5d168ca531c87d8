//! Words: what numbers with bounds are made of, one `f64` or several in lanes.

use crate::number::Scalar;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// `2^27 + 1`: a product with it separates the upper 26 bits of a factor from the lower ones.
const SPLITTER: f64 = 134_217_729.0;

/// `1.5 · 2^52`: a sum with it has no bits for a fraction.
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// A binary floating-point number with rounding to nearest, alone or in lanes.
pub(crate) trait Word:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A truth per lane.
    type Mask: Copy + Debug;

    /// A number in all lanes.
    fn of(number: f64) -> Self;
    /// Writes as many lanes as there is room for.
    fn store(self, numbers: &mut [f64]);
    /// The absolute value.
    fn size(self) -> Self;
    /// The square root.
    fn root(self) -> Self;
    /// `2^k` for a whole number k within ±1000.
    fn power_of_two(self) -> Self;
    /// Whether a number is less than another; false where one is NaN.
    fn is_less(self, other: Self) -> Self::Mask;
    /// Whether it is zero in all lanes.
    fn vanishes(self) -> bool;
    /// The first number where the truth holds, else the second.
    fn select(truth: Self::Mask, first: Self, second: Self) -> Self;
    /// Whether it holds in all lanes.
    fn all(truth: Self::Mask) -> bool;

    /// `a b` less its rounded product, exactly, unless parts of it leave the range (Dekker, Veltkamp).
    #[inline(always)]
    fn product_error(self, other: Self, product: Self) -> Self {
        let split = |factor: Self| {
            let shifted = Self::of(SPLITTER) * factor;
            let upper = shifted - (shifted - factor);
            (upper, factor - upper)
        };
        let ((a, a_rest), (b, b_rest)) = (split(self), split(other));
        (((a * b - product) + a * b_rest) + a_rest * b) + a_rest * b_rest
    }

    /// The whole number that is nearest, for sizes below 2^51.
    #[inline(always)]
    fn nearest(self) -> Self {
        (self + Self::of(SHIFT)) - Self::of(SHIFT)
    }

    /// The larger of two numbers; the second where one is NaN.
    #[inline(always)]
    fn or_larger(self, other: Self) -> Self {
        Self::select(other.is_less(self), self, other)
    }

    /// 1 where the number is negative, else 0.
    #[inline(always)]
    fn one_if_negative(self) -> Self {
        Self::select(self.is_less(Self::of(0.0)), Self::of(1.0), Self::of(0.0))
    }

    /// Whether a whole number is odd, for sizes below 2^51.
    #[inline(always)]
    fn is_odd(self) -> Self::Mask {
        let half = self * Self::of(0.5);
        Self::of(0.25).is_less((half - half.nearest()).size())
    }

    /// The number of the first lane.
    #[inline(always)]
    fn first(self) -> f64 {
        let mut first = [0.0];
        self.store(&mut first);
        first[0]
    }
}

impl Word for f64 {
    type Mask = bool;

    #[inline(always)]
    fn of(number: f64) -> Self {
        number
    }

    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        numbers[0] = self;
    }

    #[inline(always)]
    fn size(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn root(self) -> Self {
        Scalar::sqrt(self)
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        1.0.times_power_of_two(self as i32)
    }

    #[inline(always)]
    fn is_less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn vanishes(self) -> bool {
        self == 0.0
    }

    #[inline(always)]
    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }

    #[inline(always)]
    fn all(truth: bool) -> bool {
        truth
    }
}

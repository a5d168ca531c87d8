//! Truths and sizes: what comparisons of scalars give, of one number or of numbers in lanes.

use crate::number::exponent::{biased_exponent, binary_exponent};
use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Not};

/// What a comparison gives: `bool` for one number, a truth per lane for numbers in lanes.
pub trait Truth:
    Copy
    + Debug
    + Default
    + PartialEq
    + BitAnd<Output = Self>
    + BitOr<Output = Self>
    + BitXor<Output = Self>
    + Not<Output = Self>
{
    /// The same truth in all lanes.
    fn of(truth: bool) -> Self;
    /// Whether it holds in all lanes.
    fn all(self) -> bool;
    /// Whether it holds in some lane.
    fn any(self) -> bool;
}

impl Truth for bool {
    #[inline(always)]
    fn of(truth: bool) -> Self {
        truth
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// The size of a scalar, which is a real number without its derivative: `f64` for one number.
pub trait Size:
    Copy + Debug + Default + PartialEq + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// What a comparison gives.
    type Truth: Truth;

    /// A number in all lanes.
    fn of(number: f64) -> Self;
    /// The number itself; of numbers in lanes the first.
    fn first(self) -> f64;
    /// Whether this is less than a limit; false where one is NaN.
    fn is_below(self, limit: Self) -> Self::Truth;
    /// The first number where the truth holds, else the second.
    fn choose(truth: Self::Truth, first: Self, second: Self) -> Self;
    /// The whole part of a number that is not negative, and whether that is odd.
    fn whole(self) -> (Self, Self::Truth);

    /// The power of two to take out of entries of this size, and where they may stay as they are without it. One number has an exponent
    /// of its own, numbers in lanes have none.
    fn excess(self) -> (i32, Self::Truth);
    /// The exponent that brings the size into `[1, 2)`, none for zero and what is not finite. It is 0 for numbers in lanes.
    fn exponent(self) -> Option<i32>;

    /// Whether entries of this size are in the middle of the range.
    #[inline(always)]
    fn is_moderate(self) -> Self::Truth {
        Self::of(SMALL).is_below(self) & self.is_below(Self::of(LARGE))
    }

    /// The larger of two numbers.
    #[inline(always)]
    fn or_larger(self, other: Self) -> Self {
        Self::choose(self.is_below(other), other, self)
    }

    /// The smaller of two numbers.
    #[inline(always)]
    fn or_smaller(self, other: Self) -> Self {
        Self::choose(self.is_below(other), self, other)
    }

    /// 1 where the truth holds, else 0.
    #[inline(always)]
    fn one_if(truth: Self::Truth) -> Self {
        Self::choose(truth, Self::of(1.0), Self::of(0.0))
    }
}

/// Sizes beyond which entries are shifted back into the middle of the range.
const LARGE: f64 = 1e60;
const SMALL: f64 = 1e-60;

impl Size for f64 {
    type Truth = bool;

    #[inline(always)]
    fn of(number: f64) -> Self {
        number
    }
    #[inline(always)]
    fn first(self) -> f64 {
        self
    }
    #[inline(always)]
    fn is_below(self, limit: Self) -> bool {
        self < limit
    }
    #[inline(always)]
    fn choose(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }
    #[inline(always)]
    fn whole(self) -> (Self, bool) {
        let whole = self as u64;
        (whole as f64, whole & 1 == 1)
    }
    #[inline(always)]
    fn excess(self) -> (i32, bool) {
        if self.is_moderate() { (0, true) } else { (far_excess(self), true) }
    }
    #[inline(always)]
    fn exponent(self) -> Option<i32> {
        let biased = biased_exponent(self);
        if (1..0x7fe).contains(&biased) { Some(biased - 1023) } else { extreme_exponent(self) }
    }
}

/// The power of two to take out of entries beyond the middle of the range; none out of zeros and what is not finite.
#[cold]
fn far_excess(size: f64) -> i32 {
    extreme_exponent(size).unwrap_or(0)
}

/// The exponent of a size that may be zero, subnormal, almost infinite or not finite.
#[cold]
fn extreme_exponent(size: f64) -> Option<i32> {
    if size == 0.0 || !size.is_finite() { None } else { Some(binary_exponent(size)) }
}

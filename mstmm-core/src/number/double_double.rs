//! Double-double numbers: the unevaluated sum of two `f64`, good for 106 bits or about 32 digits.
//!
//! The algorithms are those of Dekker, Knuth and of Joldes, Muller and Popescu ("Tight and rigorous error bounds for
//! basic building blocks of double-word arithmetic", 2017).

mod extended;
mod functions;
mod operators;
mod products;
#[cfg(test)]
mod tests;
mod text;

use crate::number::products::{Products, exact_product};

/// `hi + lo` with `hi` the `f64` nearest to the sum: a real number of about 32 digits in the range of an `f64`.
///
/// Sizes between 2^-900 and 2^990 have all digits; outside, the parts of a product underflow or overflow. A sum or a
/// product that involves an infinity is NaN.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    // in this order, which makes the derived comparison that of the values, as `hi` is determined by the sum
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = DoubleDouble::from_double(0.0);
    const ONE: Self = DoubleDouble::from_double(1.0);

    /// The number `value`, exactly.
    const fn from_double(value: f64) -> Self {
        DoubleDouble { hi: value, lo: 0.0 }
    }

    /// The exact sum of two `f64` (Knuth): the way to make a number of two known parts.
    #[inline(always)]
    pub const fn from_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        let b_as_added = hi - a;
        let a_as_added = hi - b_as_added;
        DoubleDouble { hi, lo: (a - a_as_added) + (b - b_as_added) }
    }

    /// The exact sum of two `f64` with `|a| >= |b|` or `a = 0` (Dekker).
    #[inline(always)]
    const fn from_ordered_sum(a: f64, b: f64) -> Self {
        let hi = a + b;
        DoubleDouble { hi, lo: b - (hi - a) }
    }

    /// The exact product of two `f64` (Dekker).
    #[inline]
    pub const fn from_product(a: f64, b: f64) -> Self {
        let [hi, lo] = exact_product(a, b);
        DoubleDouble { hi, lo }
    }

    /// The exact product of two `f64`, as the machine finds it.
    #[inline(always)]
    fn product_by<P: Products>(a: f64, b: f64) -> Self {
        let [hi, lo] = P::of(a, b);
        DoubleDouble { hi, lo }
    }

    /// The two `f64` whose sum this number is, the greater first.
    #[inline]
    pub const fn parts(self) -> (f64, f64) {
        (self.hi, self.lo)
    }

    /// The absolute value.
    #[inline]
    pub const fn abs(self) -> Self {
        if self.hi < 0.0 { self.negated() } else { self }
    }

    #[inline(always)]
    const fn negated(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }

    /// The sum.
    // a call: in line, passes in extended precision were half of a program and of its compilation
    #[inline(never)]
    fn plus(self, other: Self) -> Self {
        self.added_to(other)
    }

    /// Both parts are added with their errors: the relative error is `3 u²`, `u = 2^-53`, even if the parts cancel.
    #[inline(always)]
    fn added_to(self, other: Self) -> Self {
        let upper = DoubleDouble::from_sum(self.hi, other.hi);
        let lower = DoubleDouble::from_sum(self.lo, other.lo);
        let sum = DoubleDouble::from_ordered_sum(upper.hi, upper.lo + lower.hi);
        DoubleDouble::from_ordered_sum(sum.hi, sum.lo + lower.lo)
    }

    /// The number rounded towards zero. Where `hi` has a fraction, `lo` is too small to reach the next integer.
    fn truncated(self) -> Self {
        let hi = truncate(self.hi);
        if hi != self.hi {
            return DoubleDouble::from_double(hi);
        }
        let rest = truncate(self.lo);
        // a `lo` of the other sign is taken from `hi`: its fraction then takes a whole one
        let against = rest != self.lo && (self.lo < 0.0) != (self.hi < 0.0);
        let step = if self.lo < 0.0 { -1.0 } else { 1.0 };
        DoubleDouble::from_ordered_sum(hi, if against { rest + step } else { rest })
    }
}

/// An `f64` rounded towards zero without the standard library. From 2^53 on all are integers.
fn truncate(value: f64) -> f64 {
    if value.abs() < 9_007_199_254_740_992.0 { value as i64 as f64 } else { value }
}

//! Double-double numbers: the unevaluated sum of two `f64`, good for 106 bits or about 32 digits.
//!
//! The algorithms are those of Dekker, Knuth and of Joldes, Muller and Popescu ("Tight and rigorous error bounds for
//! basic building blocks of double-word arithmetic", 2017), without fused multiply-add: where the processor has none,
//! its emulation is many times slower than the splitting of factors. Everything here is `const`, so that tables are
//! computed by the same code.

mod extended;
mod functions;
mod operators;
#[cfg(test)]
mod tests;
mod text;

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

/// `2^27 + 1`: multiplication by it separates the upper 26 bits of a factor from the lower ones.
const SPLITTER: f64 = 134_217_729.0;

/// Two parts of 26 bits with `upper + lower = a`, whose products are exact (Veltkamp).
const fn split(a: f64) -> (f64, f64) {
    let shifted = SPLITTER * a;
    let upper = shifted - (shifted - a);
    (upper, a - upper)
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = DoubleDouble::from_double(0.0);
    const ONE: Self = DoubleDouble::from_double(1.0);

    /// The number `value`, exactly.
    const fn from_double(value: f64) -> Self {
        DoubleDouble { hi: value, lo: 0.0 }
    }

    /// The exact sum of two `f64` (Knuth): the way to make a number of two known parts.
    #[inline]
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
        let hi = a * b;
        let ((a_upper, a_lower), (b_upper, b_lower)) = (split(a), split(b));
        let cross = ((a_upper * b_upper - hi) + a_upper * b_lower) + a_lower * b_upper;
        DoubleDouble { hi, lo: cross + a_lower * b_lower }
    }

    /// An integer below 2^127: exact up to 2^106, and beyond as near as the type can be.
    const fn from_integer(n: u128) -> Self {
        let hi = n as f64;
        DoubleDouble { hi, lo: (n as i128 - hi as i128) as f64 }
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

    #[inline]
    const fn negated(self) -> Self {
        DoubleDouble { hi: -self.hi, lo: -self.lo }
    }

    /// Both parts are added with their errors: the relative error is `3 u²`, `u = 2^-53`, even if the parts cancel.
    // called, as products and quotients are: in line, passes in extended precision were half of a program and of its compilation
    #[inline(never)]
    const fn plus(self, other: Self) -> Self {
        let upper = DoubleDouble::from_sum(self.hi, other.hi);
        let lower = DoubleDouble::from_sum(self.lo, other.lo);
        let sum = DoubleDouble::from_ordered_sum(upper.hi, upper.lo + lower.hi);
        DoubleDouble::from_ordered_sum(sum.hi, sum.lo + lower.lo)
    }

    /// Relative error `5 u²`.
    #[inline(never)]
    const fn times(self, other: Self) -> Self {
        let product = DoubleDouble::from_product(self.hi, other.hi);
        let cross = self.hi * other.lo + (self.lo * other.hi + self.lo * other.lo);
        DoubleDouble::from_ordered_sum(product.hi, product.lo + cross)
    }

    /// `ab + cd`, rounded once: the error is `10 u² (|ab| + |cd|)`. Products of upper parts are exact, and so is their sum. What is left
    /// out are products of lower parts, `u²` of each term; five roundings of numbers up to `4u` of the terms are the rest.
    #[inline(never)]
    const fn sum_of_products([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        let (one, other) = (DoubleDouble::from_product(a.hi, b.hi), DoubleDouble::from_product(c.hi, d.hi));
        let sum = DoubleDouble::from_sum(one.hi, other.hi);
        let cross = (a.hi * b.lo + a.lo * b.hi) + (c.hi * d.lo + c.lo * d.hi);
        // the upper parts may cancel, so that nothing is known of the order
        DoubleDouble::from_sum(sum.hi, sum.lo + ((one.lo + other.lo) + cross))
    }

    /// `self - k Σ parts`, for parts that fall by 2^53 each: as every product is exact, the error is relative to what is
    /// left after the first subtraction, and not to `self`.
    #[inline]
    const fn minus_multiple(mut self, k: f64, parts: &[f64]) -> Self {
        let mut i = 0;
        while i < parts.len() {
            self = self.plus(DoubleDouble::from_product(-k, parts[i]));
            i += 1;
        }
        self
    }

    /// Long division with three quotient digits of 53 bits, so that the quotient is rounded but once.
    #[inline(never)]
    const fn over(self, divisor: Self) -> Self {
        let first = self.hi / divisor.hi;
        if first == 0.0 || !first.is_finite() {
            // nothing to refine, and the remainder of an infinity would be NaN
            return DoubleDouble::from_double(first);
        }
        let divisor_parts = [divisor.hi, divisor.lo];
        let rest = self.minus_multiple(first, &divisor_parts);
        let second = rest.hi / divisor.hi;
        let third = rest.minus_multiple(second, &divisor_parts).hi / divisor.hi;
        let quotient = DoubleDouble::from_ordered_sum(first, second);
        DoubleDouble::from_ordered_sum(quotient.hi, quotient.lo + third)
    }

    /// The number rounded towards zero. Where `hi` has a fraction, `lo` is too small to reach the next integer.
    const fn truncated(self) -> Self {
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
const fn truncate(value: f64) -> f64 {
    if value.abs() < 9_007_199_254_740_992.0 { value as i64 as f64 } else { value }
}

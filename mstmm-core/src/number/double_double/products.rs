//! Products of double-doubles.

use crate::number::double_double::DoubleDouble;
use crate::number::products::{Operation, Products, on_machine};

impl DoubleDouble {
    /// The product, with a relative error of `5 u²`.
    #[inline(always)]
    pub(super) fn times_by<P: Products>(self, other: Self) -> Self {
        let product = DoubleDouble::product_by::<P>(self.hi, other.hi);
        let cross = self.hi * other.lo + (self.lo * other.hi + self.lo * other.lo);
        DoubleDouble::from_ordered_sum(product.hi, product.lo + cross)
    }

    /// `ab + cd`, rounded once: the error is `10 u² (|ab| + |cd|)`. Products of upper parts are exact, and so is their sum. What is left
    /// out are products of lower parts, `u²` of each term; five roundings of numbers up to `4u` of the terms are the rest.
    #[inline(always)]
    fn sum_of_products<P: Products>([a, b]: [Self; 2], [c, d]: [Self; 2]) -> Self {
        let (one, other) = (DoubleDouble::product_by::<P>(a.hi, b.hi), DoubleDouble::product_by::<P>(c.hi, d.hi));
        let sum = DoubleDouble::from_sum(one.hi, other.hi);
        let cross = (a.hi * b.lo + a.lo * b.hi) + (c.hi * d.lo + c.lo * d.hi);
        // the upper parts may cancel, so that nothing is known of the order
        DoubleDouble::from_sum(sum.hi, sum.lo + ((one.lo + other.lo) + cross))
    }

    /// The product of complex numbers, given by their parts.
    #[inline(always)]
    pub(super) fn complex_product_by<P: Products>([re, im]: [Self; 2], [other_re, other_im]: [Self; 2]) -> [Self; 2] {
        let of_re = DoubleDouble::sum_of_products::<P>([re, other_re], [im.negated(), other_im]);
        [of_re, DoubleDouble::sum_of_products::<P>([re, other_im], [im, other_re])]
    }

    /// `self - k Σ parts`, for parts that fall by 2^53 each: as every product is exact, the error is relative to what is
    /// left after the first subtraction, and not to `self`.
    #[inline(always)]
    pub(super) fn minus_multiple<P: Products>(mut self, k: f64, parts: &[f64]) -> Self {
        for part in parts {
            self = self.added_to(DoubleDouble::product_by::<P>(-k, *part));
        }
        self
    }

    /// Long division with three quotient digits of 53 bits, so that the quotient is rounded but once.
    #[inline(always)]
    fn over_by<P: Products>(self, divisor: Self) -> Self {
        let first = self.hi / divisor.hi;
        if first == 0.0 || !first.is_finite() {
            // nothing to refine, and the remainder of an infinity would be NaN
            return DoubleDouble::from_double(first);
        }
        let divisor_parts = [divisor.hi, divisor.lo];
        let rest = self.minus_multiple::<P>(first, &divisor_parts);
        let second = rest.hi / divisor.hi;
        let third = rest.minus_multiple::<P>(second, &divisor_parts).hi / divisor.hi;
        let quotient = DoubleDouble::from_ordered_sum(first, second);
        DoubleDouble::from_ordered_sum(quotient.hi, quotient.lo + third)
    }

    /// The quotient.
    #[inline(never)]
    pub(super) fn over(self, divisor: Self) -> Self {
        on_machine(Over(self, divisor))
    }

    /// The quotient of complex numbers, given by their parts: the product with the conjugate divisor over its square.
    #[inline(never)]
    pub(super) fn over_complex(dividend: [Self; 2], divisor: [Self; 2]) -> [Self; 2] {
        on_machine(OverComplex(dividend, divisor))
    }

    /// The product.
    // a call, as the sum is
    #[inline(never)]
    pub(super) fn times(self, other: Self) -> Self {
        on_machine(Times(self, other))
    }

    /// The product of complex numbers, given by their parts.
    #[inline(never)]
    pub(super) fn times_complex(a: [Self; 2], b: [Self; 2]) -> [Self; 2] {
        on_machine(TimesComplex(a, b))
    }
}

/// A product.
struct Times(DoubleDouble, DoubleDouble);

impl Operation for Times {
    type Output = DoubleDouble;

    #[inline(always)]
    fn by<P: Products>(self) -> DoubleDouble {
        self.0.times_by::<P>(self.1)
    }
}

/// A product of complex numbers.
struct TimesComplex([DoubleDouble; 2], [DoubleDouble; 2]);

impl Operation for TimesComplex {
    type Output = [DoubleDouble; 2];

    #[inline(always)]
    fn by<P: Products>(self) -> [DoubleDouble; 2] {
        DoubleDouble::complex_product_by::<P>(self.0, self.1)
    }
}

/// A quotient.
struct Over(DoubleDouble, DoubleDouble);

impl Operation for Over {
    type Output = DoubleDouble;

    #[inline(always)]
    fn by<P: Products>(self) -> DoubleDouble {
        self.0.over_by::<P>(self.1)
    }
}

/// A quotient of complex numbers.
struct OverComplex([DoubleDouble; 2], [DoubleDouble; 2]);

impl Operation for OverComplex {
    type Output = [DoubleDouble; 2];

    #[inline(always)]
    fn by<P: Products>(self) -> [DoubleDouble; 2] {
        let OverComplex(dividend, [re, im]) = self;
        let inverse = DoubleDouble::ONE.over_by::<P>(DoubleDouble::sum_of_products::<P>([re, re], [im, im]));
        let [of_re, of_im] = DoubleDouble::complex_product_by::<P>(dividend, [re, im.negated()]);
        [of_re.times_by::<P>(inverse), of_im.times_by::<P>(inverse)]
    }
}

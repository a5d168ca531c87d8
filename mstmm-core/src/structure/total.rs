//! What is multiplied and counted while a structure is eliminated: Δ and its natural frequencies.

use crate::number::{Scalar, Scaled, Size};

/// The product of all pivots and charts, which is Δ at the end, and the count.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Total<S: Scalar> {
    product: S,
    exponent: i64,
    /// Negative pivots and natural frequencies of held members, less the number of forces: at the end the frequencies below.
    pub(crate) below: S::Size,
}

impl<S: Scalar> Total<S> {
    /// Nothing yet.
    pub(crate) fn new() -> Self {
        Total { product: S::one(), exponent: 0, below: S::Size::of(0.0) }
    }

    /// Not a number, of a structure that could not be eliminated.
    pub(crate) fn unknown() -> Self {
        Total { product: S::from_f64(f64::NAN), ..Total::new() }
    }

    /// Δ, once all unknowns have left.
    pub(crate) fn delta(&self) -> Scaled<S> {
        Scaled::new(self.product, self.exponent)
    }

    /// Multiplies Δ by a number and a power of two.
    #[inline]
    pub(super) fn multiply(&mut self, factor: S, exponent: i64) {
        let product = self.product * factor;
        let ([product], shift) = S::in_range([product], product.size());
        self.product = product;
        self.exponent += exponent + i64::from(shift);
    }

    /// Includes a member: the product and the count of its chart.
    pub(super) fn include(&mut self, product: Scaled<S>, below: S::Size) {
        self.multiply(product.mantissa(), product.exponent());
        self.below = self.below + below;
    }

    /// Multiplies Δ by a pivot, and counts it.
    #[inline]
    pub(super) fn pivot(&mut self, pivot: S) {
        self.multiply(pivot, 0);
        self.below = self.below + S::Size::one_if(pivot.is_negative());
    }
}

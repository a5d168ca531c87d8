//! What is multiplied and counted while a network is evaluated by stiffnesses.

use crate::number::{Scalar, Size, binary_exponent, power_of_two};
use crate::pass::network::stiffness::waves::{Bending, Line, Waves};

/// Sizes of a product beyond which a power of two is taken out.
const SMALL: f64 = 1e-30;
const LARGE: f64 = 1e30;

/// Size of a product of pivots below which, or beyond whose inverse, they are multiplied one by one.
const PRODUCT: f64 = 1e-200;

/// The product of all pivots and minors, which is Δ but for a factor without zeros, and the count.
#[derive(Clone, Copy, Debug)]
pub(super) struct StiffnessTotal<S: Scalar> {
    pub(super) product: S,
    pub(super) exponent: i64,
    pub(super) below: S::Size,
}

impl<S: Scalar> StiffnessTotal<S> {
    #[inline(always)]
    pub(super) fn new() -> Self {
        StiffnessTotal { product: S::one(), exponent: 0, below: S::Size::of(0.0) }
    }

    /// Includes a member: its minor, and its frequencies with both ends held.
    #[inline(always)]
    pub(super) fn include<const ENTRIES: usize>(&mut self, waves: &Waves<S, ENTRIES>) {
        self.multiply(waves.minor, i64::from(waves.exponent));
        self.below = self.below + waves.below;
    }

    /// Includes a beam, across and along.
    #[inline(always)]
    pub(super) fn include_both(&mut self, across: &Bending<S>, along: &Line<S>) {
        self.multiply(across.minor * along.minor, i64::from(across.exponent) + i64::from(along.exponent));
        self.below = self.below + across.below + along.below;
    }

    /// Multiplies Δ by a factor and a power of two. In lanes the first one tells the power that is taken out.
    #[inline(always)]
    pub(super) fn multiply(&mut self, factor: S, exponent: i64) {
        self.product *= factor;
        self.exponent += exponent;
        let size = self.product.size().first();
        if !(size > SMALL && size < LARGE) {
            self.take_power_out(size);
        }
    }

    /// Multiplies Δ by a product, or by its factors one by one where that leaves the range.
    #[inline(always)]
    pub(super) fn multiply_by_all(&mut self, product: S, factors: &[S]) {
        let size = product.size().first();
        if size > PRODUCT && size < 1.0 / PRODUCT {
            return self.multiply(product, 0);
        }
        for factor in factors {
            self.multiply(*factor, 0);
        }
    }

    /// Takes the power of two of a size out of the product, if it is a number.
    #[inline(always)]
    fn take_power_out(&mut self, size: f64) {
        if size > 0.0 && size < f64::INFINITY {
            let own = binary_exponent(size);
            self.product = self.product.scaled(power_of_two(-own));
            self.exponent += i64::from(own);
        }
    }
}

//! The operators, between numbers with derivatives and with an `f64` on either side.

use crate::number::partials::Partials;
use core::ops::{Add, Div, Mul, Neg, Sub};

impl<const K: usize> Add for Partials<K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.chain_of_two(other, self.value + other.value, [1.0, 1.0])
    }
}

impl<const K: usize> Sub for Partials<K> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.chain_of_two(other, self.value - other.value, [1.0, -1.0])
    }
}

impl<const K: usize> Mul for Partials<K> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.chain_of_two(other, self.value * other.value, [other.value, self.value])
    }
}

impl<const K: usize> Div for Partials<K> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.chain_of_two(other, value, [1.0 / other.value, -value / other.value])
    }
}

impl<const K: usize> Neg for Partials<K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

/// Implements an operator with an `f64` on either side.
macro_rules! with_f64 {
    ($($trait:ident, $method:ident, $operator:tt;)*) => {$(
        impl<const K: usize> $trait<f64> for Partials<K> {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                self $operator Partials::constant(other)
            }
        }

        impl<const K: usize> $trait<Partials<K>> for f64 {
            type Output = Partials<K>;
            #[inline]
            fn $method(self, other: Partials<K>) -> Partials<K> {
                Partials::constant(self) $operator other
            }
        }
    )*};
}
with_f64! { Add, add, +; Sub, sub, -; Mul, mul, *; Div, div, /; }

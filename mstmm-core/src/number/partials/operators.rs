//! The operators, between numbers with derivatives and with an `f64` on either side.

use crate::number::elementary::Elementary;
use crate::number::partials::Partials;
use core::ops::{Add, Div, Mul, Neg, Sub};

impl<const K: usize, V: Elementary> Add for Partials<K, V> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        self.chain_of_two(other, self.value + other.value, [V::constant(1.0), V::constant(1.0)])
    }
}

impl<const K: usize, V: Elementary> Sub for Partials<K, V> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self.chain_of_two(other, self.value - other.value, [V::constant(1.0), V::constant(-1.0)])
    }
}

impl<const K: usize, V: Elementary> Mul for Partials<K, V> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        self.chain_of_two(other, self.value * other.value, [other.value, self.value])
    }
}

impl<const K: usize, V: Elementary> Div for Partials<K, V> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        self.chain_of_two(other, value, [V::constant(1.0) / other.value, -value / other.value])
    }
}

impl<const K: usize, V: Elementary> Neg for Partials<K, V> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.chain(-self.value, V::constant(-1.0))
    }
}

/// Implements an operator with an `f64` on either side.
macro_rules! with_f64 {
    ($($trait:ident, $method:ident, $operator:tt;)*) => {$(
        impl<const K: usize, V: Elementary> $trait<f64> for Partials<K, V> {
            type Output = Self;
            #[inline]
            fn $method(self, other: f64) -> Self {
                self $operator Partials::constant(other)
            }
        }

        impl<const K: usize, V: Elementary> $trait<Partials<K, V>> for f64 {
            type Output = Partials<K, V>;
            #[inline]
            fn $method(self, other: Partials<K, V>) -> Partials<K, V> {
                Partials::constant(self) $operator other
            }
        }
    )*};
}
with_f64! { Add, add, +; Sub, sub, -; Mul, mul, *; Div, div, /; }

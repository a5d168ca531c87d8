//! The operators of dual numbers. Of numbers in extended precision derivatives that vanish are left out.

use crate::number::dual::Dual;
use crate::number::frequency::Real;
use crate::number::scalar::Scalar;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_complex::Complex;

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        match [self, other].map(|part| part.is_known_constant()) {
            [false, false] => Dual { value, derivative: self.derivative + other.derivative },
            [true, _] => Dual { value, derivative: other.derivative },
            [false, true] => Dual { value, derivative: self.derivative },
        }
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        let value = self.value - other.value;
        match [self, other].map(|part| part.is_known_constant()) {
            [false, false] => Dual { value, derivative: self.derivative - other.derivative },
            [true, _] => Dual { value, derivative: -other.derivative },
            [false, true] => Dual { value, derivative: self.derivative },
        }
    }
}

impl<S: Scalar> Dual<S> {
    /// `f'g + fg'`.
    #[inline]
    fn derivative_of_product(self, other: Self) -> S {
        self.derivative.product(other.value) + self.value.product(other.derivative)
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let value = self.value.product(other.value);
        match [self, other].map(|part| part.is_known_constant()) {
            [false, false] => Dual { value, derivative: self.derivative_of_product(other) },
            [true, false] => Dual { value, derivative: self.value.product(other.derivative) },
            [false, true] => Dual { value, derivative: self.derivative.product(other.value) },
            [true, true] => Dual::constant(value),
        }
    }
}

impl<S: Scalar> Div for Dual<S> {
    type Output = Self;
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value.quotient(other.value);
        match [self, other].map(|part| part.is_known_constant()) {
            [false, false] => {
                Dual { value, derivative: (self.derivative - value.product(other.derivative)).quotient(other.value) }
            }
            [true, false] => Dual { value, derivative: -value.product(other.derivative).quotient(other.value) },
            [false, true] => Dual { value, derivative: self.derivative.quotient(other.value) },
            [true, true] => Dual::constant(value),
        }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|part| -part)
    }
}

impl<T: Real> Mul<T> for Dual<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|part| part * factor)
    }
}

impl<T: Real> Mul<T> for Dual<Complex<T>> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        self.map(|part| part * factor)
    }
}

/// Implements the assigning form of an operator.
macro_rules! assign {
    ($($trait:ident, $method:ident, $operator:tt;)*) => {$(
        impl<S: Scalar> $trait for Dual<S> {
            #[inline]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}
assign! { AddAssign, add_assign, +; SubAssign, sub_assign, -; MulAssign, mul_assign, *; DivAssign, div_assign, /; }

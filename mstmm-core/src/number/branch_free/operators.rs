//! Operators of branch-free numbers: those of the scalar inside.

use crate::number::branch_free::BranchFree;
use crate::number::frequency::Real;
use crate::number::scalar::Scalar;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// Implements operators of two numbers.
macro_rules! operators {
    ($($trait:ident, $method:ident, $operator:tt;)*) => {$(
        impl<S: Scalar, const SERIES: bool> $trait for BranchFree<S, SERIES> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                BranchFree(self.0 $operator other.0)
            }
        }
    )*};
}
operators! { Add, add, +; Sub, sub, -; Mul, mul, *; Div, div, /; }

/// Implements the assigning form of operators.
macro_rules! assigning_operators {
    ($($trait:ident, $method:ident, $operator:tt;)*) => {$(
        impl<S: Scalar, const SERIES: bool> $trait for BranchFree<S, SERIES> {
            #[inline(always)]
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}
assigning_operators! { AddAssign, add_assign, +; SubAssign, sub_assign, -; MulAssign, mul_assign, *; }

impl<S: Scalar, const SERIES: bool> Neg for BranchFree<S, SERIES> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        BranchFree(-self.0)
    }
}

impl<S: Scalar + Mul<T, Output = S>, T: Real, const SERIES: bool> Mul<T> for BranchFree<S, SERIES> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        BranchFree(self.0 * factor)
    }
}

impl<S: Scalar, const SERIES: bool> Zero for BranchFree<S, SERIES> {
    #[inline(always)]
    fn zero() -> Self {
        BranchFree(S::zero())
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<S: Scalar, const SERIES: bool> One for BranchFree<S, SERIES> {
    #[inline(always)]
    fn one() -> Self {
        BranchFree(S::one())
    }
}

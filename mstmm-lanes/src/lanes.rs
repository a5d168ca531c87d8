//! A number of several lanes with the operators and traits of numbers.

#[cfg(target_arch = "x86_64")]
use crate::avx512::Eight;
#[cfg(target_arch = "x86_64")]
use crate::plain::Plain;
use crate::vector::Vector;
use core::fmt::{self, Debug};
use core::ops::{Add, AddAssign, BitAnd, BitOr, BitXor, Div, DivAssign, Mul, MulAssign, Neg, Not};
use core::ops::{Sub, SubAssign};
use num_traits::{One, Zero};

/// Numbers in lanes, each computed with the bits that it has alone.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Lanes<V>(pub V);

/// A truth per lane.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Truths<V: Vector>(pub V::Mask);

impl<V: Vector> Lanes<V> {
    /// A number in all lanes.
    #[inline(always)]
    pub fn splat(number: f64) -> Self {
        Lanes(V::splat(number))
    }

    /// The numbers as an array; zeros behind those of the last lane.
    #[inline(always)]
    pub fn to_array(self) -> [f64; 8] {
        let mut numbers = [0.0; 8];
        self.0.store(&mut numbers[..V::LANES]);
        numbers
    }

    /// Whether a number is less than another.
    #[inline(always)]
    pub fn is_less(self, other: Self) -> Truths<V> {
        Truths(self.0.is_less(other.0))
    }

    /// The product less its rounded value: exactly, unless it underflows.
    #[inline(always)]
    pub fn product_error(self, other: Self, product: Self) -> Self {
        Lanes(self.0.product_error(other.0, product.0))
    }

    /// The first number where the truth holds, else the second.
    #[inline(always)]
    pub fn select(truth: Truths<V>, first: Self, second: Self) -> Self {
        Lanes(V::select(truth.0, first.0, second.0))
    }
}

/// Implements an operator and its assigning form.
macro_rules! operators {
    ($($trait:ident, $method:ident, $assign:ident, $assign_method:ident, $vector:ident;)*) => {$(
        impl<V: Vector> $trait for Lanes<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Lanes(self.0.$vector(other.0))
            }
        }

        impl<V: Vector> $assign for Lanes<V> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    )*};
}
operators! {
    Add, add, AddAssign, add_assign, sum;
    Sub, sub, SubAssign, sub_assign, difference;
    Mul, mul, MulAssign, mul_assign, product;
    Div, div, DivAssign, div_assign, quotient;
}

impl<V: Vector> Mul<f64> for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: f64) -> Self {
        self * Lanes::splat(factor)
    }
}

/// The product with plain numbers, a lane with a lane.
#[cfg(target_arch = "x86_64")]
impl Mul<Lanes<Plain>> for Lanes<Eight> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: Lanes<Plain>) -> Self {
        self * Lanes(Eight::load(factor.0.numbers()))
    }
}

impl<V: Vector> Neg for Lanes<V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Lanes(self.0.negated())
    }
}

impl<V: Vector> Zero for Lanes<V> {
    #[inline(always)]
    fn zero() -> Self {
        Lanes::splat(0.0)
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        Truths::<V>(self.0.is_nought()).all()
    }
}

impl<V: Vector> One for Lanes<V> {
    #[inline(always)]
    fn one() -> Self {
        Lanes::splat(1.0)
    }
}

impl<V: Vector> Default for Lanes<V> {
    #[inline(always)]
    fn default() -> Self {
        Lanes::splat(0.0)
    }
}

impl<V: Vector> PartialEq for Lanes<V> {
    fn eq(&self, other: &Self) -> bool {
        self.to_array() == other.to_array()
    }
}

impl<V: Vector> Debug for Lanes<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.to_array()[..V::LANES]).finish()
    }
}

impl<V: Vector> Truths<V> {
    /// A truth in all lanes.
    #[inline(always)]
    pub fn splat(truth: bool) -> Self {
        Truths(V::mask(truth))
    }

    /// Whether it holds in all lanes.
    #[inline(always)]
    pub fn all(self) -> bool {
        V::bits(self.0) == V::bits(V::mask(true))
    }

    /// Whether it holds in some lane.
    #[inline(always)]
    pub fn any(self) -> bool {
        V::bits(self.0) != 0
    }

    /// A bit per lane, that of the first lane last.
    #[inline(always)]
    pub fn bits(self) -> u8 {
        V::bits(self.0)
    }
}

/// Implements an operator of two truths.
macro_rules! connectives {
    ($($trait:ident, $method:ident, $vector:ident;)*) => {$(
        impl<V: Vector> $trait for Truths<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Truths(V::$vector(self.0, other.0))
            }
        }
    )*};
}
connectives! { BitAnd, bitand, both; BitOr, bitor, either; BitXor, bitxor, one_of; }

impl<V: Vector> Not for Truths<V> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Truths(V::not(self.0))
    }
}

impl<V: Vector> Default for Truths<V> {
    #[inline(always)]
    fn default() -> Self {
        Truths::splat(false)
    }
}

impl<V: Vector> PartialEq for Truths<V> {
    fn eq(&self, other: &Self) -> bool {
        self.bits() == other.bits()
    }
}

impl<V: Vector> Debug for Truths<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#b}", self.bits())
    }
}

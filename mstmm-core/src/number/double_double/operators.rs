//! The operators, each by the arithmetic of the parent module.

use crate::number::double_double::DoubleDouble;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};
use num_traits::{One, Zero};

/// Implements an operator and its assigning form.
macro_rules! operator {
    ($trait:ident, $method:ident, $assign:ident, $assign_method:ident, $a:ident, $b:ident, $value:expr) => {
        impl $trait for DoubleDouble {
            type Output = Self;
            #[inline]
            fn $method(self, $b: Self) -> Self {
                let $a = self;
                $value
            }
        }

        impl $assign for DoubleDouble {
            #[inline]
            fn $assign_method(&mut self, other: Self) {
                *self = $trait::$method(*self, other);
            }
        }
    };
}

operator!(Add, add, AddAssign, add_assign, a, b, a.plus(b));
operator!(Sub, sub, SubAssign, sub_assign, a, b, a.plus(b.negated()));
operator!(Mul, mul, MulAssign, mul_assign, a, b, a.times(b));
operator!(Div, div, DivAssign, div_assign, a, b, a.over(b));
operator!(Rem, rem, RemAssign, rem_assign, a, b, remainder(a, b));

/// The remainder of `a/b`, with the sign of `a`; good to rounding of `a` as long as the quotient has fewer digits than the type.
fn remainder(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let rest = a - b * (a / b).truncated();
    let step = if (a.hi < 0.0) == (b.hi < 0.0) { b } else { -b };
    // a quotient next to an integer may have been rounded to the wrong side of it
    if rest.hi != 0.0 && (rest.hi < 0.0) != (a.hi < 0.0) {
        rest + step
    } else if (rest.hi < 0.0 && rest <= step) || (rest.hi > 0.0 && rest >= step) {
        rest - step
    } else {
        rest
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.negated()
    }
}

impl Zero for DoubleDouble {
    #[inline]
    fn zero() -> Self {
        DoubleDouble::ZERO
    }

    #[inline]
    fn is_zero(&self) -> bool {
        self.hi == 0.0
    }
}

impl One for DoubleDouble {
    #[inline]
    fn one() -> Self {
        DoubleDouble::ONE
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        DoubleDouble::from_double(value)
    }
}

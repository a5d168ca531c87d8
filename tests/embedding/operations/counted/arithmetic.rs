//! The operators of the counting scalar, with what an optimiser folds left out.

use super::Counted;
use super::tape::{self, Operation, Origin};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};
use mstmm::number::Scalar;
use num_traits::{Num, One, Zero};

const ZERO: Origin = Origin::Constant(0.0);
const ONE: Origin = Origin::Constant(1.0);

impl Add for Counted {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.binary(Operation::Add, other, self.value + other.value)
    }
}

impl Sub for Counted {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        if other.origin == ZERO { self } else { self.binary(Operation::Add, other, self.value - other.value) }
    }
}

impl Mul for Counted {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        match (self.origin, other.origin) {
            (ONE, _) => other,
            (_, ONE) => self,
            _ => self.binary(Operation::Multiply, other, self.value * other.value),
        }
    }
}

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.origin == ONE { self } else { self.binary(Operation::Divide, other, self.value / other.value) }
    }
}

/// In no formula of the library: numbers over which there are complex ones must have it.
impl Rem for Counted {
    type Output = Self;
    fn rem(self, other: Self) -> Self {
        self.binary(Operation::Divide, other, self.value % other.value)
    }
}

impl Neg for Counted {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Operation::Free, -self.value)
    }
}

macro_rules! assignments {
    ($($assign:ident::$method:ident = $operator:tt;)*) => {$(
        impl $assign for Counted {
            fn $method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

assignments! {
    AddAssign::add_assign = +;
    SubAssign::sub_assign = -;
    MulAssign::mul_assign = *;
    DivAssign::div_assign = /;
    RemAssign::rem_assign = %;
}

impl Zero for Counted {
    fn zero() -> Self {
        Counted { value: 0.0, origin: ZERO }
    }

    fn is_zero(&self) -> bool {
        tape::look_at(self.origin);
        self.value == 0.0
    }
}

impl One for Counted {
    fn one() -> Self {
        Counted { value: 1.0, origin: ONE }
    }
}

impl Num for Counted {
    type FromStrRadixErr = <f64 as Num>::FromStrRadixErr;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        f64::from_str_radix(text, radix).map(Counted::from_f64)
    }
}

impl Default for Counted {
    fn default() -> Self {
        Counted::zero()
    }
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        tape::look_at(self.origin);
        tape::look_at(other.origin);
        self.value == other.value
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        tape::look_at(self.origin);
        tape::look_at(other.origin);
        self.value.partial_cmp(&other.value)
    }
}

//! What sizes of sections are made of.

use crate::number::elementary::Elementary;
use crate::number::interval::Interval;
use crate::number::{Partials, elementary};
use core::ops::{Add, Div, Mul, Sub};

/// A plain number, or one with derivatives: `f64` and [`Partials`].
pub trait Number:
    Copy
    + sealed::Sealed
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// A number that depends on nothing.
    fn constant(value: f64) -> Self;

    /// What is not defined: neither it nor its derivatives are known over a box of sizes.
    #[doc(hidden)]
    fn undefined() -> Self;

    /// Its least and its greatest value, which are one for all but intervals.
    #[doc(hidden)]
    fn ends(self) -> [f64; 2];

    /// The smaller and the larger one of two; of equal ones each once.
    #[doc(hidden)]
    fn sorted(self, other: Self) -> [Self; 2];

    /// The exponential function.
    #[must_use]
    fn exponential(self) -> Self;
}

impl Number for f64 {
    fn undefined() -> Self {
        f64::NAN
    }

    fn constant(value: f64) -> Self {
        value
    }

    fn ends(self) -> [f64; 2] {
        [self; 2]
    }

    fn sorted(self, other: Self) -> [Self; 2] {
        [self.min(other), other.max(self)]
    }

    fn exponential(self) -> Self {
        elementary!(f64::exp, libm::exp, self)
    }
}

/// Numbers with derivatives, given the slope of what is not defined and the ends of a value.
macro_rules! with_derivatives {
    ($($value:ty, $slope:expr, $ends:expr;)*) => {$(
        impl<const K: usize> Number for Partials<K, $value> {
            fn constant(value: f64) -> Self {
                Partials::constant(value)
            }

            fn undefined() -> Self {
                let [value, slope]: [$value; 2] = [f64::NAN, $slope].map(Elementary::constant);
                Partials { value, partials: [slope; K] }
            }

            fn ends(self) -> [f64; 2] {
                $ends(self.value)
            }

            fn sorted(self, other: Self) -> [Self; 2] {
                [self.min(other), other.max(self)]
            }

            fn exponential(self) -> Self {
                self.exp()
            }
        }

        impl<const K: usize> sealed::Sealed for Partials<K, $value> {}
    )*};
}

with_derivatives! {
    f64, 0.0, |value| [value; 2];
    Interval, f64::NAN, |value: Interval| [value.low, value.high];
}

mod sealed {
    /// Keeps the trait to the numbers of this crate.
    pub trait Sealed {}

    impl Sealed for f64 {}
}

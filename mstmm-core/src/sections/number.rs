//! What sizes of sections are made of.

use crate::number::Partials;
use crate::number::elementary;
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

    /// Its value.
    fn value(self) -> f64;

    /// The exponential function.
    #[must_use]
    fn exponential(self) -> Self;
}

impl Number for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn value(self) -> f64 {
        self
    }

    fn exponential(self) -> Self {
        elementary!(f64::exp, libm::exp, self)
    }
}

impl<const K: usize> Number for Partials<K> {
    fn constant(value: f64) -> Self {
        Partials::constant(value)
    }

    fn value(self) -> f64 {
        self.value
    }

    fn exponential(self) -> Self {
        self.exp()
    }
}

mod sealed {
    /// Keeps the trait to the numbers of this crate.
    pub trait Sealed {}

    impl Sealed for f64 {}
    impl<const K: usize> Sealed for crate::number::Partials<K> {}
}

//! What formulas of models compute with: the functions of `f64` that have a derivative, over plain numbers and over intervals.

use crate::number::floats::elementary;
use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number of a formula: `f64`, or an [`Interval`](crate::Interval) that holds all its values.
pub trait Elementary:
    Copy
    + Debug
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// A plain number.
    fn constant(value: f64) -> Self;
    /// Whether it is a number; of an interval whether both ends are finite numbers.
    fn is_number(self) -> bool;
    /// Whether it is zero and nothing else.
    fn is_zero(self) -> bool;
    /// Whether it is below another one; none where it may be either way.
    fn is_below(self, other: Self) -> Option<bool>;
    /// All that lies between two.
    #[must_use]
    fn hull(self, other: Self) -> Self;
    /// The smaller one of two.
    #[must_use]
    fn lesser(self, other: Self) -> Self;
    /// The larger one of two.
    #[must_use]
    fn greater(self, other: Self) -> Self;
    /// Its absolute value.
    #[must_use]
    fn absolute(self) -> Self;
    /// The sign of its bits, 1 or -1.
    #[must_use]
    fn sign(self) -> Self;
    /// A power whose exponent is a whole number.
    #[must_use]
    fn whole_power(self, exponent: f64) -> Self;
    /// A power.
    #[must_use]
    fn power(self, exponent: Self) -> Self;
    /// The angle of the point `(x, self)`, and its slopes along this number and along x.
    #[must_use]
    fn angle(self, x: Self) -> (Self, [Self; 2]);
    /// `sqrt(a² + b²)`.
    #[must_use]
    fn diagonal(self, other: Self) -> Self;
    /// One of the functions of one number.
    #[must_use]
    fn of(self, function: Function) -> Self;
}

/// Lists the functions of one number: by their names in `f64` and in `libm`.
macro_rules! functions {
    ($($(#[$doc:meta])* $function:ident, $name:ident, $libm:path;)*) => {
        /// A function of one number.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Function {
            $($(#[$doc])* $function,)*
        }

        impl Function {
            /// Its value, as the standard library or `libm` has it.
            #[inline]
            pub(super) fn at(self, x: f64) -> f64 {
                match self {
                    $(Function::$function => elementary!(f64::$name, $libm, x),)*
                }
            }
        }
    };
}

functions! {
    /// Square root.
    Sqrt, sqrt, libm::sqrt;
    /// Cube root.
    Cbrt, cbrt, libm::cbrt;
    /// `e^x`.
    Exp, exp, libm::exp;
    /// `e^x - 1`.
    ExpM1, exp_m1, libm::expm1;
    /// Natural logarithm.
    Ln, ln, libm::log;
    /// `ln(1 + x)`.
    Ln1P, ln_1p, libm::log1p;
    /// Logarithm to the base of 10.
    Log10, log10, libm::log10;
    /// Logarithm to the base of 2.
    Log2, log2, libm::log2;
    /// Sine.
    Sin, sin, libm::sin;
    /// Cosine.
    Cos, cos, libm::cos;
    /// Tangent.
    Tan, tan, libm::tan;
    /// Inverse sine.
    Asin, asin, libm::asin;
    /// Inverse cosine.
    Acos, acos, libm::acos;
    /// Inverse tangent.
    Atan, atan, libm::atan;
    /// Hyperbolic sine.
    Sinh, sinh, libm::sinh;
    /// Hyperbolic cosine.
    Cosh, cosh, libm::cosh;
    /// Hyperbolic tangent.
    Tanh, tanh, libm::tanh;
}

impl Elementary for f64 {
    fn constant(value: f64) -> Self {
        value
    }

    fn is_number(self) -> bool {
        !self.is_nan()
    }

    fn is_zero(self) -> bool {
        self == 0.0
    }

    fn is_below(self, other: Self) -> Option<bool> {
        Some(self < other)
    }

    fn hull(self, _: Self) -> Self {
        self
    }

    fn lesser(self, other: Self) -> Self {
        self.min(other)
    }

    fn greater(self, other: Self) -> Self {
        self.max(other)
    }

    fn absolute(self) -> Self {
        self.abs()
    }

    fn sign(self) -> Self {
        self.signum()
    }

    fn whole_power(self, exponent: f64) -> Self {
        self.power(exponent)
    }

    fn power(self, exponent: Self) -> Self {
        elementary!(f64::powf, libm::pow, self, exponent)
    }

    fn angle(self, x: Self) -> (Self, [Self; 2]) {
        let square = self * self + x * x;
        (elementary!(f64::atan2, libm::atan2, self, x), [x / square, -self / square])
    }

    fn diagonal(self, other: Self) -> Self {
        elementary!(f64::hypot, libm::hypot, self, other)
    }

    #[inline]
    fn of(self, function: Function) -> Self {
        function.at(self)
    }
}

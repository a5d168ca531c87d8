//! The functions of `f64` that have a derivative, under their names.

use crate::number::floats::elementary;
use crate::number::partials::Partials;
use core::f64::consts::{LN_2, LN_10};

/// A function of `f64` by its name there and in `libm`, with its slope from its argument `x` and its value `y`.
macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident, $libm:path, |$x:ident, $y:ident| $slope:expr;)*) => {
        impl<const K: usize> Partials<K> {$(
            $(#[$doc])*
            #[must_use]
            pub fn $name(self) -> Self {
                let $x = self.value;
                let $y = elementary!(f64::$name, $libm, $x);
                self.chain($y, $slope)
            }
        )*}
    };
}

functions! {
    /// Square root, `dy = dx/(2 y)`.
    sqrt, libm::sqrt, |x, y| 0.5 / y;
    /// Cube root, `dy = dx/(3 y²)`.
    cbrt, libm::cbrt, |x, y| 1.0 / (3.0 * y * y);
    /// Exponential function, `dy = y dx`.
    exp, libm::exp, |x, y| y;
    /// `exp(x) - 1`, `dy = (y + 1) dx`.
    exp_m1, libm::expm1, |x, y| y + 1.0;
    /// Natural logarithm, `dy = dx/x`.
    ln, libm::log, |x, y| 1.0 / x;
    /// `ln(1 + x)`, `dy = dx/(1 + x)`.
    ln_1p, libm::log1p, |x, y| 1.0 / (1.0 + x);
    /// Logarithm to the base of 10, `dy = dx/(x ln 10)`.
    log10, libm::log10, |x, y| 1.0 / (x * LN_10);
    /// Logarithm to the base of 2, `dy = dx/(x ln 2)`.
    log2, libm::log2, |x, y| 1.0 / (x * LN_2);
    /// Sine, `dy = cos x dx`.
    sin, libm::sin, |x, y| elementary!(f64::cos, libm::cos, x);
    /// Cosine, `dy = -sin x dx`.
    cos, libm::cos, |x, y| -elementary!(f64::sin, libm::sin, x);
    /// Tangent, `dy = (1 + y²) dx`.
    tan, libm::tan, |x, y| 1.0 + y * y;
    /// Inverse sine, `dy = dx/sqrt(1 - x²)`.
    asin, libm::asin, |x, y| 1.0 / elementary!(f64::sqrt, libm::sqrt, (1.0 - x) * (1.0 + x));
    /// Inverse cosine, `dy = -dx/sqrt(1 - x²)`.
    acos, libm::acos, |x, y| -1.0 / elementary!(f64::sqrt, libm::sqrt, (1.0 - x) * (1.0 + x));
    /// Inverse tangent, `dy = dx/(1 + x²)`.
    atan, libm::atan, |x, y| 1.0 / (1.0 + x * x);
    /// Hyperbolic sine, `dy = cosh x dx`.
    sinh, libm::sinh, |x, y| elementary!(f64::cosh, libm::cosh, x);
    /// Hyperbolic cosine, `dy = sinh x dx`.
    cosh, libm::cosh, |x, y| elementary!(f64::sinh, libm::sinh, x);
    /// Hyperbolic tangent, `dy = dx/cosh² x`.
    tanh, libm::tanh, |x, y| {
        let cosh = elementary!(f64::cosh, libm::cosh, x);
        1.0 / (cosh * cosh)
    };
}

impl<const K: usize> Partials<K> {
    /// Reciprocal, `dy = -y² dx`.
    #[must_use]
    pub fn recip(self) -> Self {
        let recip = 1.0 / self.value;
        self.chain(recip, -recip * recip)
    }

    /// Absolute value, `dy = ±dx`.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    /// Sign, 1 or -1, with derivative zero.
    #[must_use]
    pub fn signum(self) -> Self {
        Partials::constant(self.value.signum())
    }

    /// Degrees as radians.
    #[must_use]
    pub fn to_radians(self) -> Self {
        self * 1_f64.to_radians()
    }

    /// Radians as degrees.
    #[must_use]
    pub fn to_degrees(self) -> Self {
        self * 1_f64.to_degrees()
    }

    /// Whole power, `dy = n x^(n - 1) dx`.
    #[must_use]
    pub fn powi(self, exponent: i32) -> Self {
        let n = f64::from(exponent);
        // a constant at x = 0 too
        let slope = if exponent == 0 { 0.0 } else { n * power(self.value, n - 1.0) };
        self.chain(power(self.value, n), slope)
    }

    /// Power, `dy = b a^(b - 1) da + a^b ln a db`.
    #[must_use]
    pub fn powf(self, exponent: Self) -> Self {
        let (a, b) = (self.value, exponent.value);
        let value = power(a, b);
        let of_base = if b == 0.0 { 0.0 } else { b * power(a, b - 1.0) };
        let of_exponent = if value == 0.0 { 0.0 } else { value * elementary!(f64::ln, libm::log, a) };
        self.chain_of_two(exponent, value, [of_base, of_exponent])
    }

    /// Angle of the point `(x, y)`, `dφ = (x dy - y dx)/(x² + y²)`; `self` is y.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let value = elementary!(f64::atan2, libm::atan2, self.value, x.value);
        self.chain_of_two(x, value, [x.value / square, -self.value / square])
    }

    /// `sqrt(a² + b²)`, `dy = (a da + b db)/y`.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        let value = elementary!(f64::hypot, libm::hypot, self.value, other.value);
        self.chain_of_two(other, value, [self.value / value, other.value / value])
    }

    /// The smaller of two; the one that is a number, if the other is none.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if other.value < self.value || self.value.is_nan() { other } else { self }
    }

    /// The larger of two; the one that is a number, if the other is none.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if other.value > self.value || self.value.is_nan() { other } else { self }
    }

    /// The nearest number of an interval.
    #[must_use]
    pub fn clamp(self, least: Self, greatest: Self) -> Self {
        // unlike `min` and `max`, not a number stays what it is
        let raised = if self.value < least.value { least } else { self };
        if raised.value > greatest.value { greatest } else { raised }
    }

    /// `self · factor + summand`.
    #[must_use]
    pub fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }
}

/// `base^exponent`
fn power(base: f64, exponent: f64) -> f64 {
    elementary!(f64::powf, libm::pow, base, exponent)
}

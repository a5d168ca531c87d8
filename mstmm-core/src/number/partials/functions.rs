//! The functions of `f64` that have a derivative, under their names.

use crate::number::elementary::{Elementary, Function};
use crate::number::partials::Partials;
use core::f64::consts::{LN_2, LN_10};

/// A function by its name, with its slope from its argument `x` and its value `y`.
macro_rules! functions {
    ($($(#[$doc:meta])* $name:ident, $function:ident, |$x:ident, $y:ident| $slope:expr;)*) => {
        impl<const K: usize, V: Elementary> Partials<K, V> {$(
            $(#[$doc])*
            #[must_use]
            pub fn $name(self) -> Self {
                let $x = self.value;
                let $y = $x.of(Function::$function);
                self.chain($y, $slope)
            }
        )*}
    };
}

functions! {
    /// Square root, `dy = dx/(2 y)`.
    sqrt, Sqrt, |x, y| V::constant(0.5) / y;
    /// Cube root, `dy = dx/(3 y²)`.
    cbrt, Cbrt, |x, y| V::constant(1.0) / (V::constant(3.0) * y * y);
    /// Exponential function, `dy = y dx`.
    exp, Exp, |x, y| y;
    /// `exp(x) - 1`, `dy = (y + 1) dx`.
    exp_m1, ExpM1, |x, y| y + V::constant(1.0);
    /// Natural logarithm, `dy = dx/x`.
    ln, Ln, |x, y| V::constant(1.0) / x;
    /// `ln(1 + x)`, `dy = dx/(1 + x)`.
    ln_1p, Ln1P, |x, y| V::constant(1.0) / (V::constant(1.0) + x);
    /// Logarithm to the base of 10, `dy = dx/(x ln 10)`.
    log10, Log10, |x, y| V::constant(1.0) / (x * V::constant(LN_10));
    /// Logarithm to the base of 2, `dy = dx/(x ln 2)`.
    log2, Log2, |x, y| V::constant(1.0) / (x * V::constant(LN_2));
    /// Sine, `dy = cos x dx`.
    sin, Sin, |x, y| x.of(Function::Cos);
    /// Cosine, `dy = -sin x dx`.
    cos, Cos, |x, y| -x.of(Function::Sin);
    /// Tangent, `dy = (1 + y²) dx`.
    tan, Tan, |x, y| V::constant(1.0) + y * y;
    /// Inverse sine, `dy = dx/sqrt(1 - x²)`.
    asin, Asin, |x, y| V::constant(1.0) / ((V::constant(1.0) - x) * (V::constant(1.0) + x)).of(Function::Sqrt);
    /// Inverse cosine, `dy = -dx/sqrt(1 - x²)`.
    acos, Acos, |x, y| -V::constant(1.0) / ((V::constant(1.0) - x) * (V::constant(1.0) + x)).of(Function::Sqrt);
    /// Inverse tangent, `dy = dx/(1 + x²)`.
    atan, Atan, |x, y| V::constant(1.0) / (V::constant(1.0) + x * x);
    /// Hyperbolic sine, `dy = cosh x dx`.
    sinh, Sinh, |x, y| x.of(Function::Cosh);
    /// Hyperbolic cosine, `dy = sinh x dx`.
    cosh, Cosh, |x, y| x.of(Function::Sinh);
    /// Hyperbolic tangent, `dy = dx/cosh² x`.
    tanh, Tanh, |x, y| {
        let cosh = x.of(Function::Cosh);
        V::constant(1.0) / (cosh * cosh)
    };
}

impl<const K: usize, V: Elementary> Partials<K, V> {
    /// Reciprocal, `dy = -y² dx`.
    #[must_use]
    pub fn recip(self) -> Self {
        let recip = V::constant(1.0) / self.value;
        self.chain(recip, -recip * recip)
    }

    /// Absolute value, `dy = ±dx`.
    #[must_use]
    pub fn abs(self) -> Self {
        match self.value.is_below(V::constant(0.0)) {
            Some(true) => -self,
            Some(false) => self,
            None => Partials { value: self.value.absolute(), ..self.hull(-self) },
        }
    }

    /// Sign, 1 or -1, with derivative zero.
    #[must_use]
    pub fn signum(self) -> Self {
        let sign = self.value.sign();
        // about zero it jumps
        let slope = if sign.is_below(V::constant(1.0)).is_some() { 0.0 } else { f64::NAN };
        self.chain(sign, V::constant(slope))
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
        let slope = if exponent == 0 { V::constant(0.0) } else { V::constant(n) * self.value.whole_power(n - 1.0) };
        self.chain(self.value.whole_power(n), slope)
    }

    /// Power, `dy = b a^(b - 1) da + a^b ln a db`.
    #[must_use]
    pub fn powf(self, exponent: Self) -> Self {
        let (a, b) = (self.value, exponent.value);
        let value = a.power(b);
        let zero = V::constant(0.0);
        let of_base = if b.is_zero() { zero } else { b * a.power(b - V::constant(1.0)) };
        let of_exponent = if value.is_zero() { zero } else { value * a.of(Function::Ln) };
        self.chain_of_two(exponent, value, [of_base, of_exponent])
    }

    /// Angle of the point `(x, y)`, `dφ = (x dy - y dx)/(x² + y²)`; `self` is y.
    #[must_use]
    pub fn atan2(self, x: Self) -> Self {
        let (value, slopes) = self.value.angle(x.value);
        self.chain_of_two(x, value, slopes)
    }

    /// `sqrt(a² + b²)`, `dy = (a da + b db)/y`.
    #[must_use]
    pub fn hypot(self, other: Self) -> Self {
        let value = self.value.diagonal(other.value);
        self.chain_of_two(other, value, [self.value / value, other.value / value])
    }

    /// The smaller of two; the one that is a number, if the other is none.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        match other.value.is_below(self.value) {
            Some(true) => other,
            Some(false) if self.value.is_number() => self,
            Some(false) => other,
            None => Partials { value: self.value.lesser(other.value), ..self.hull(other) },
        }
    }

    /// The larger of two; the one that is a number, if the other is none.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        match self.value.is_below(other.value) {
            Some(true) => other,
            Some(false) if self.value.is_number() => self,
            Some(false) => other,
            None => Partials { value: self.value.greater(other.value), ..self.hull(other) },
        }
    }

    /// The nearest number of an interval.
    #[must_use]
    pub fn clamp(self, least: Self, greatest: Self) -> Self {
        // what is not a number stays what it is, which `min` and `max` would drop
        if self.value.is_number() { self.max(least).min(greatest) } else { self }
    }

    /// `self · factor + summand`.
    #[must_use]
    pub fn mul_add(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    /// All that lies between two.
    fn hull(self, other: Self) -> Self {
        let partial = |field| V::hull(self.partials[field], other.partials[field]);
        Partials { value: self.value.hull(other.value), partials: core::array::from_fn(partial) }
    }
}

//! Numbers without a derivative, where others have one: complex frequencies in extended precision are multiplied by parameters.

use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{ComplexEigenvalue, Frequency, Real};
use crate::number::products::Products;
use crate::number::scalar::Scalar;
use crate::number::wave_functions::{WaveFunctions, WaveProducts};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use num_complex::Complex;
use num_traits::{One, Zero};

/// A number alone, as [`Dual`](crate::Dual) is one with its derivative.
///
/// Rust lets no crate but that of complex numbers say what a complex number times a parameter of another type is; this type is this crate's own.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Value<S>(
    /// The number.
    pub S,
);

/// Implements operators and their assigning forms: each does what the operator of the number does.
macro_rules! operators {
    ($($trait:ident, $method:ident, $assign:ident, $assign_method:ident, $operator:tt;)*) => {$(
        impl<S: Scalar> $trait for Value<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Value(self.0 $operator other.0)
            }
        }

        impl<S: Scalar> $assign for Value<S> {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                self.0 = self.0 $operator other.0;
            }
        }
    )*};
}
operators! {
    Add, add, AddAssign, add_assign, +;
    Sub, sub, SubAssign, sub_assign, -;
}

impl<S: Scalar> Mul for Value<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Value(self.0.product(other.0))
    }
}

impl<S: Scalar> Div for Value<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Value(self.0.quotient(other.0))
    }
}

impl<S: Scalar> DivAssign for Value<S> {
    #[inline(always)]
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<S: Scalar> MulAssign for Value<S> {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<S: Scalar> Neg for Value<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Value(-self.0)
    }
}

impl<S: Scalar> Zero for Value<S> {
    #[inline(always)]
    fn zero() -> Self {
        Value(S::zero())
    }
    #[inline(always)]
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<S: Scalar> One for Value<S> {
    #[inline(always)]
    fn one() -> Self {
        Value(S::one())
    }
}

impl<T> From<Complex<T>> for Value<Complex<T>> {
    fn from(number: Complex<T>) -> Self {
        Value(number)
    }
}

impl<T> From<Value<Complex<T>>> for Complex<T> {
    fn from(Value(number): Value<Complex<T>>) -> Self {
        number
    }
}

/// Both numbers of a pair.
#[inline(always)]
fn both<S>((first, second): (S, S)) -> (Value<S>, Value<S>) {
    (Value(first), Value(second))
}

impl<S: Scalar> Scalar for Value<S> {
    type Truth = S::Truth;
    type Size = S::Size;
    const IN_LANES: bool = S::IN_LANES;
    const EPSILON: f64 = S::EPSILON;
    const WAVE_LIMIT: f64 = S::WAVE_LIMIT;
    const SERIES_TERMS: usize = S::SERIES_TERMS;
    const LONGEST_IN_LINE: usize = S::LONGEST_IN_LINE;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Value(S::from_f64(value))
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        Value(S::reciprocal_factorial(n))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Value(self.0.sqrt())
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        both(self.0.sin_cos())
    }

    #[inline(always)]
    fn sinh_cosh(self) -> (Self, Self) {
        both(self.0.sinh_cosh())
    }

    #[inline(always)]
    fn wave_functions(self) -> WaveFunctions<Self> {
        let WaveFunctions { sin, cos, sh, ch, one, exponents } = self.0.wave_functions();
        WaveFunctions { sin: Value(sin), cos: Value(cos), sh: Value(sh), ch: Value(ch), one: Value(one), exponents }
    }

    #[inline(always)]
    fn even_waves(self) -> EvenWaves<Self> {
        let EvenWaves { cosh, sinhc, one, exponent } = self.0.even_waves();
        EvenWaves { cosh: Value(cosh), sinhc: Value(sinhc), one: Value(one), exponent }
    }

    #[inline(always)]
    fn wave_products(self) -> WaveProducts<Self> {
        let WaveProducts { ch_cos, ch_sin, sh_cos, sh_sin, one, exponent } = self.0.wave_products();
        let [ch_cos, ch_sin, sh_cos, sh_sin, one] = [ch_cos, ch_sin, sh_cos, sh_sin, one].map(Value);
        WaveProducts { ch_cos, ch_sin, sh_cos, sh_sin, one, exponent }
    }

    #[inline(always)]
    fn short_wave_products(self) -> [Self; 5] {
        self.0.short_wave_products().map(Value)
    }

    #[inline(always)]
    fn select(truth: S::Truth, first: Self, second: Self) -> Self {
        Value(S::select(truth, first.0, second.0))
    }

    #[inline(always)]
    fn is_negative(self) -> S::Truth {
        self.0.is_negative()
    }

    #[inline(always)]
    fn less_product<P: Products>(self, a: Self, b: Self) -> Self {
        Value(self.0.less_product::<P>(a.0, b.0))
    }

    #[inline(always)]
    fn times_real(self, real: Self) -> Self {
        Value(self.0.times_real(real.0))
    }

    #[inline(always)]
    fn vanishes(self) -> S::Truth {
        self.0.vanishes()
    }

    #[inline(always)]
    fn size(self) -> S::Size {
        self.0.size()
    }

    #[inline(always)]
    fn times_power_of_two(self, exponent: i32) -> Self {
        Value(self.0.times_power_of_two(exponent))
    }

    #[inline(always)]
    fn scaled(self, power: f64) -> Self {
        Value(self.0.scaled(power))
    }

    #[inline(always)]
    fn valid_if(self, condition: S::Truth) -> Self {
        Value(self.0.valid_if(condition))
    }
}

impl<T: Real> Mul<T> for Value<Complex<T>> {
    type Output = Self;

    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Value(self.0 * factor)
    }
}

impl<T: Real> Frequency<T> for Value<Complex<T>> {
    type Meaning = ComplexEigenvalue;

    #[inline]
    fn lambda_squared(self) -> Self {
        self * self
    }

    #[inline]
    fn omega(self) -> Self {
        Value(Frequency::<T>::omega(self.0))
    }

    #[inline]
    fn signed_omega(self) -> Self {
        Frequency::<T>::omega(self)
    }

    #[inline]
    fn from_parameter(parameter: T) -> Self {
        Value(Frequency::from_parameter(parameter))
    }
}

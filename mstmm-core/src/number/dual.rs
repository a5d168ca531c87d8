//! Dual numbers: a value and its derivative with respect to the frequency.

mod operators;

use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{ComplexEigenvalue, Frequency, Parameter, Real, RealFrequency};
use crate::number::products::Products;
use crate::number::scalar::{Scalar, is_long, short_wave_products_and_slopes};
use crate::number::wave_functions::{WaveFunctions, WaveProducts};
use core::ops::{Rem, RemAssign};
use num_complex::Complex;
use num_traits::{Num, One, Zero};

/// `value + derivative ε` with `ε² = 0`. Order and equality look at the value alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct Dual<S> {
    /// The value.
    pub value: S,
    /// Its derivative.
    pub derivative: S,
}

impl<S: Scalar> Dual<S> {
    /// The variable itself: derivative 1.
    #[inline]
    pub fn variable(value: S) -> Self {
        Dual { value, derivative: S::one() }
    }

    /// A constant: derivative 0.
    #[inline]
    pub fn constant(value: S) -> Self {
        Dual { value, derivative: S::zero() }
    }

    /// Both parts through one linear map.
    #[inline]
    fn map(self, f: impl Fn(S) -> S) -> Self {
        Dual { value: f(self.value), derivative: f(self.derivative) }
    }

    /// The wave functions of `self`, from those of its value.
    #[inline(always)]
    fn of_waves(self, waves: WaveFunctions<S>) -> WaveFunctions<Self> {
        let WaveFunctions { sin, cos, sh, ch, one, exponents } = waves;
        WaveFunctions {
            sin: self.chain(sin, cos),
            cos: self.chain(cos, -sin),
            sh: self.chain(sh, ch),
            ch: self.chain(ch, sh),
            one: Dual::constant(one),
            exponents,
        }
    }

    /// A function by its value and slope at `self.value`.
    #[inline]
    fn chain(self, value: S, slope: S) -> Self {
        if self.is_known_constant() {
            Dual::constant(value)
        } else {
            Dual { value, derivative: slope * self.derivative }
        }
    }

    /// Whether its derivative is seen to vanish: in extended precision, where an operation costs far more than a look.
    #[inline(always)]
    fn is_known_constant(&self) -> bool {
        is_long::<S>() && self.derivative.is_zero()
    }
}

impl<S: Scalar> PartialEq for Dual<S> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: Scalar> Zero for Dual<S> {
    #[inline]
    fn zero() -> Self {
        Dual::constant(S::zero())
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.value.is_zero()
    }
}

impl<S: Scalar> One for Dual<S> {
    #[inline]
    fn one() -> Self {
        Dual::constant(S::one())
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    type Truth = S::Truth;
    type Size = S::Size;
    const IN_LANES: bool = S::IN_LANES;
    const EPSILON: f64 = S::EPSILON;
    const WAVE_LIMIT: f64 = S::WAVE_LIMIT;
    const SERIES_TERMS: usize = S::SERIES_TERMS;
    const LONGEST_IN_LINE: usize = S::LONGEST_IN_LINE;

    #[inline]
    fn from_f64(value: f64) -> Self {
        Dual::constant(S::from_f64(value))
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        Dual::constant(S::reciprocal_factorial(n))
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        if self.is_known_constant() { Dual::constant(root) } else { self.chain(root, S::from_f64(0.5) / root) }
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        let (sinh, cosh) = self.value.sinh_cosh();
        (self.chain(sinh, cosh), self.chain(cosh, sinh))
    }

    #[inline]
    fn wave_functions(self) -> WaveFunctions<Self> {
        self.of_waves(self.value.wave_functions())
    }

    /// Through the square and never through its root, whose derivative is infinite at zero.
    #[inline]
    fn even_waves(self) -> EvenWaves<Self> {
        let waves = self.value.even_waves();
        let [slope_of_cosh, slope_of_sinhc] = waves.slopes(self.value);
        EvenWaves {
            cosh: self.chain(waves.cosh, slope_of_cosh),
            sinhc: self.chain(waves.sinhc, slope_of_sinhc),
            one: Dual::constant(waves.one),
            exponent: waves.exponent,
        }
    }

    // called where size counts: programs of two beams have one copy
    #[inline]
    fn wave_products(self) -> WaveProducts<Self> {
        let WaveProducts { ch_cos, ch_sin, sh_cos, sh_sin, one, exponent } = self.value.wave_products();
        WaveProducts {
            ch_cos: self.chain(ch_cos, sh_cos - ch_sin),
            ch_sin: self.chain(ch_sin, sh_sin + ch_cos),
            sh_cos: self.chain(sh_cos, ch_cos - sh_sin),
            sh_sin: self.chain(sh_sin, ch_sin + sh_cos),
            one: Dual::constant(one),
            exponent,
        }
    }

    #[inline(always)]
    fn short_wave_products(self) -> [Self; 5] {
        let [c, b, f, d, e] = short_wave_products_and_slopes(self.value);
        let number = |[value, slope]: [S; 2]| self.chain(value, slope);
        [number(c), number(b), number(f), number(d), number(e)]
    }

    #[inline(always)]
    fn select(truth: S::Truth, first: Self, second: Self) -> Self {
        Dual {
            value: S::select(truth, first.value, second.value),
            derivative: S::select(truth, first.derivative, second.derivative),
        }
    }

    #[inline(always)]
    fn valid_if(self, condition: S::Truth) -> Self {
        Dual { value: self.value.valid_if(condition), ..self }
    }

    #[inline(always)]
    fn vanishes(self) -> S::Truth {
        self.value.vanishes()
    }

    #[inline(always)]
    fn is_negative(self) -> S::Truth {
        self.value.is_negative()
    }

    #[inline]
    fn size(self) -> S::Size {
        self.value.size()
    }

    #[inline]
    fn times_power_of_two(self, exponent: i32) -> Self {
        self.map(|part| part.times_power_of_two(exponent))
    }

    #[inline(always)]
    fn is_constant_zero(self) -> bool {
        self.value.is_zero() && self.derivative.is_zero()
    }

    #[inline(always)]
    fn less_product<P: Products>(self, a: Self, b: Self) -> Self {
        let value = self.value.less_product::<P>(a.value, b.value);
        let [a_is_known, b_is_known] = [a, b].map(|factor| factor.is_known_constant());
        let mut derivative = self.derivative;
        if !a_is_known {
            derivative = derivative.less_product::<P>(a.derivative, b.value);
        }
        if !b_is_known {
            derivative = derivative.less_product::<P>(a.value, b.derivative);
        }
        Dual { value, derivative }
    }

    #[inline]
    fn times_real(self, real: Self) -> Self {
        let derivative = if self.is_known_constant() { S::zero() } else { self.derivative.times_real(real.value) };
        Dual { value: self.value.times_real(real.value), derivative }
    }

    #[inline]
    fn scaled(self, power: f64) -> Self {
        self.map(|part| part.scaled(power))
    }
}

impl<T: Real> Frequency<T> for Dual<T> {
    type Meaning = RealFrequency;

    #[inline]
    fn lambda_squared(self) -> Self {
        -(self * self)
    }

    #[inline]
    fn omega(self) -> Self {
        self.abs()
    }

    #[inline]
    fn signed_omega(self) -> Self {
        self
    }

    #[inline]
    fn from_parameter(parameter: T) -> Self {
        Dual::constant(parameter)
    }
}

impl<T: Real> Frequency<T> for Dual<Complex<T>> {
    type Meaning = ComplexEigenvalue;

    #[inline]
    fn lambda_squared(self) -> Self {
        self * self
    }

    #[inline]
    fn omega(self) -> Self {
        self.map(Frequency::<T>::omega)
    }

    #[inline]
    fn signed_omega(self) -> Self {
        Frequency::<T>::omega(self)
    }

    #[inline]
    fn from_parameter(parameter: T) -> Self {
        Dual::constant(Frequency::from_parameter(parameter))
    }
}

impl<T: Real> PartialOrd for Dual<T> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<core::cmp::Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<T: Real> Rem for Dual<T> {
    type Output = Self;
    #[inline]
    fn rem(self, other: Self) -> Self {
        Dual { value: self.value % other.value, derivative: self.derivative }
    }
}

impl<T: Real> RemAssign for Dual<T> {
    #[inline]
    fn rem_assign(&mut self, other: Self) {
        *self = *self % other;
    }
}

impl<T: Real> Num for Dual<T> {
    type FromStrRadixErr = T::FromStrRadixErr;
    #[inline]
    fn from_str_radix(digits: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        T::from_str_radix(digits, radix).map(Dual::constant)
    }
}

impl<T: Real> Parameter for Dual<T> {
    #[inline]
    fn abs(self) -> Self {
        if self.value < T::zero() { -self } else { self }
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
}

impl<T: Real> Real for Dual<T> {
    type Extended = Self;
    type ExtendedComplex = Complex<Self>;

    const IS_ITS_WORDS: bool = false;

    #[inline]
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::scalar::short_wave_products;
    use crate::number::tolerance::assert_close;

    /// Oracle: the same series in dual arithmetic, whose product rule knows nothing of the slope of a polynomial.
    #[test]
    fn slopes_of_short_waves_are_those_of_dual_arithmetic() {
        for z_fourth in [0.0, 1e-9, 0.3, -0.7, 1.0] {
            let x = Dual { value: z_fourth, derivative: 1.7 };
            for (found, expected) in x.short_wave_products().into_iter().zip(short_wave_products(x)) {
                assert_eq!(found.value, expected.value, "{z_fourth}");
                assert_close(found.derivative, expected.derivative, 1.0, 4.0);
            }
        }
    }
}

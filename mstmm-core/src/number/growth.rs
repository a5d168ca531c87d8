//! Rates at which motions grow: real eigenvalues of undamped systems, for which ω² is below zero.

use crate::number::double_double::DoubleDouble;
use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{Frequency, Real, RealFrequency};
use crate::number::scalar::{Scalar, single};
use crate::number::wave_functions::WaveFunctions;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// A real eigenvalue λ in 1/s of an undamped motion, which grows as `e^{λt}`: `λ² = +x²`, where a real frequency has `λ² = -ω²`.
///
/// Searches count at it how many motions grow. That is far below all wave frequencies, where the formulas of waves are their series in
/// `λ²`; beyond, for a beam with `m l⁴λ²/EI > 1`, waves that know a root of ω do not hold.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Growth<T>(pub T);

/// Implements an operator and its assigning form, if it has one.
macro_rules! operator {
    ($($trait:ident, $method:ident, $operator:tt $(, $assign:ident, $assign_method:ident)?;)*) => {$(
        impl<T: Real> $trait for Growth<T> {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                Growth(self.0 $operator other.0)
            }
        }

        $(
            impl<T: Real> $assign for Growth<T> {
                #[inline]
                fn $assign_method(&mut self, other: Self) {
                    *self = *self $operator other;
                }
            }
        )?
    )*};
}
operator! {
    Add, add, +, AddAssign, add_assign;
    Sub, sub, -, SubAssign, sub_assign;
    Mul, mul, *, MulAssign, mul_assign;
    Div, div, /;
}

impl<T: Real> Neg for Growth<T> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Growth(-self.0)
    }
}

impl<T: Real> Mul<T> for Growth<T> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: T) -> Self {
        Growth(self.0 * factor)
    }
}

impl Mul<f64> for Growth<DoubleDouble> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: f64) -> Self {
        Growth(self.0 * factor)
    }
}

impl<T: Real> Zero for Growth<T> {
    #[inline]
    fn zero() -> Self {
        Growth(T::zero())
    }
    #[inline]
    fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl<T: Real> One for Growth<T> {
    #[inline]
    fn one() -> Self {
        Growth(T::one())
    }
}

impl<T: Real> Scalar for Growth<T> {
    single!();
    const EPSILON: f64 = T::EPSILON;
    const WAVE_LIMIT: f64 = T::WAVE_LIMIT;
    const SERIES_TERMS: usize = T::SERIES_TERMS;
    // a search takes one or two such passes: calls compile faster
    const LONGEST_IN_LINE: usize = 0;

    #[inline]
    fn from_f64(value: f64) -> Self {
        Growth(T::from_f64(value))
    }

    #[inline]
    fn reciprocal_factorial(n: usize) -> Self {
        Growth(T::reciprocal_factorial(n))
    }

    #[inline]
    fn sqrt(self) -> Self {
        Growth(self.0.sqrt())
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Growth(sin), Growth(cos))
    }

    #[inline]
    fn sinh_cosh(self) -> (Self, Self) {
        let (sinh, cosh) = self.0.sinh_cosh();
        (Growth(sinh), Growth(cosh))
    }

    #[inline]
    fn wave_functions(self) -> WaveFunctions<Self> {
        let WaveFunctions { sin, cos, sh, ch, one, exponents } = self.0.wave_functions();
        let [sin, cos, sh, ch, one] = [sin, cos, sh, ch, one].map(Growth);
        WaveFunctions { sin, cos, sh, ch, one, exponents }
    }

    #[inline]
    fn even_waves(self) -> EvenWaves<Self> {
        let EvenWaves { cosh, sinhc, one, exponent } = self.0.even_waves();
        EvenWaves { cosh: Growth(cosh), sinhc: Growth(sinhc), one: Growth(one), exponent }
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.0.is_negative()
    }

    #[inline]
    fn vanishes(self) -> bool {
        self.0.vanishes()
    }

    #[inline]
    fn size(self) -> f64 {
        self.0.size()
    }

    #[inline]
    fn times_power_of_two(self, exponent: i32) -> Self {
        Growth(self.0.times_power_of_two(exponent))
    }

    #[inline]
    fn scaled(self, power: f64) -> Self {
        Growth(self.0.scaled(power))
    }
}

/// Implements the rates of systems with parameters of a type.
macro_rules! rate {
    ($([$($generic:tt)*] $number:ty, $parameter:ty, $is_extended:literal;)*) => {$(
        impl<$($generic)*> Frequency<$parameter> for Growth<$number> {
            // that of an undamped motion: no damper takes it
            type Meaning = RealFrequency;
            const IS_EXTENDED: bool = $is_extended;

            #[inline]
            fn lambda_squared(self) -> Self {
                self * self
            }

            /// `|λ|`, the size of an ω that is imaginary: wave numbers are below the limit of their series where it tells so.
            #[inline]
            fn omega(self) -> Self {
                Growth(self.0.abs())
            }

            #[inline]
            fn from_parameter(parameter: $parameter) -> Self {
                Growth(<$number as Frequency<$parameter>>::from_parameter(parameter))
            }
        }
    )*};
}
rate! {
    [T: Real] T, T, false;
    [] DoubleDouble, f64, true;
}

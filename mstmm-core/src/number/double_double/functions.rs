//! The elementary functions: reduction of the argument, then a Taylor series.

use crate::number::double_double::DoubleDouble;
use crate::number::dual::Dual;
use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{ComplexEigenvalue, Frequency, Parameter, Real, RealFrequency};
use crate::number::scalar::{Scalar, single};
use crate::number::wave_functions::WaveFunctions;
use core::f64::consts;
use core::ops::Mul;
use num_complex::Complex;

/// `π/2` in four parts of 53 bits: the multiples below 2^51 keep 106 bits even where the reduced argument is small.
const HALF_PI: [f64; 4] =
    [consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33, 5.562_271_104_316_826e-50];

/// `ln 2` in three parts; its multiples stay below 2^11.
const LN_2: [f64; 3] = [consts::LN_2, 2.319_046_813_846_299_6e-17, 5.707_708_438_416_212e-34];

/// Beyond it, an angle cannot be reduced by [`nearest_integer`] and the parts of `π/2`.
const ANGLE_LIMIT: f64 = 1_125_899_906_842_624.0;

/// Beyond it, the exponential is out of range on either side.
const EXP_LIMIT: f64 = 750.0;

/// Below it, `sh x` is summed up: the difference of two exponentials would cancel.
const SERIES_LIMIT: f64 = 1.0;

/// `1/n!` up to the last that a series over `SERIES_TERMS` asks for.
const RECIPROCAL_FACTORIALS: [DoubleDouble; 41] = {
    let mut table = [DoubleDouble::ONE; 41];
    // `n! = odd · 2^twos`, exact: 40! has 160 bits, its odd part 121
    let (mut odd, mut twos) = (1_u128, 0);
    let mut n = 1;
    while n < 41 {
        odd *= n as u128;
        twos += odd.trailing_zeros();
        odd >>= odd.trailing_zeros();
        let (quotient, power) = (DoubleDouble::ONE.over(DoubleDouble::from_integer(odd)), (1_u64 << twos) as f64);
        table[n] = DoubleDouble { hi: quotient.hi / power, lo: quotient.lo / power };
        n += 1;
    }
    table
};

/// How many terms of a Taylor series count.
#[derive(Clone, Copy)]
struct Terms {
    /// Distance between the factorials of successive terms.
    stride: usize,
    /// Number of terms that need all digits; the next is below 1e-17 of the first.
    double: usize,
    /// Number of terms that count at all; the next is below 1e-34 of the first.
    all: usize,
}

/// For the exponential of `|y| <= ln 2 / 2`.
const EVERY: Terms = Terms { stride: 1, double: 13, all: 25 };

/// For sines and cosines, circular or hyperbolic, of a square `|y| <= 1`.
const EVERY_OTHER: Terms = Terms { stride: 2, double: 9, all: 15 };

/// `Σ_k y^k / (stride·k + first)!` by Horner's rule; the small terms in `f64`, which is all they need.
#[inline]
fn taylor(y: DoubleDouble, first: usize, terms: Terms) -> DoubleDouble {
    let coefficient = |k: usize| RECIPROCAL_FACTORIALS[terms.stride * k + first];
    let tail = (terms.double..terms.all).rev().fold(0.0, |sum, k| sum * y.hi + coefficient(k).hi);
    let tail = DoubleDouble::from_double(tail);
    (0..terms.double).rev().fold(tail, |sum, k| sum * y + coefficient(k))
}

/// `sin x` and `cos x` for `y = -x²`, or `sh x` and `ch x` for `y = x²`. The leading term is added last, so that it
/// takes on no error but that of one rounding.
#[inline]
fn sine_and_cosine(x: DoubleDouble, y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    (x + x * (y * taylor(y, 3, EVERY_OTHER)), DoubleDouble::ONE + y * taylor(y, 2, EVERY_OTHER))
}

/// The integer nearest to a number of size below 2^51: the sum with `1.5 · 2^52` has no bits for a fraction.
fn nearest_integer(value: f64) -> f64 {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    (value + SHIFT) - SHIFT
}

impl Scalar for DoubleDouble {
    single!();
    /// 2^-104: what a handful of roundings may leave, each being up to `5 · 2^-106`.
    const EPSILON: f64 = f64::EPSILON * f64::EPSILON;
    const WAVE_LIMIT: f64 = 100.0;
    const SERIES_TERMS: usize = 10;
    // extended precision is seldom needed, and its steps are long in line
    const LONGEST_IN_LINE: usize = 6;

    #[inline]
    fn from_f64(value: f64) -> Self {
        DoubleDouble::from_double(value)
    }

    #[inline(always)]
    fn reciprocal_factorial(n: usize) -> Self {
        RECIPROCAL_FACTORIALS[n]
    }

    /// One Newton step from the root in `f64`, whose residual is exact.
    fn sqrt(self) -> Self {
        let root = Scalar::sqrt(self.hi);
        if root == 0.0 || !root.is_finite() {
            return DoubleDouble::from_double(root);
        }
        let residual = self.minus_multiple(root, &[root]);
        DoubleDouble::from_ordered_sum(root, residual.hi / (2.0 * root))
    }

    /// NaN for angles of 2^50 and more.
    fn sin_cos(self) -> (Self, Self) {
        if self.hi.is_nan() || self.hi.abs() >= ANGLE_LIMIT {
            let nan = DoubleDouble::from_double(f64::NAN);
            return (nan, nan);
        }
        let quarters = nearest_integer(self.hi * consts::FRAC_2_PI);
        let x = self.minus_multiple(quarters, &HALF_PI);
        let (sin, cos) = sine_and_cosine(x, -(x * x));
        match (quarters as i64) & 3 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    fn sinh_cosh(self) -> (Self, Self) {
        if self.hi.abs() < SERIES_LIMIT {
            return sine_and_cosine(self, self * self);
        }
        let e = self.exp();
        let inverse = DoubleDouble::ONE / e;
        ((e - inverse).times_power_of_two(-1), (e + inverse).times_power_of_two(-1))
    }

    #[inline]
    fn wave_functions(self) -> WaveFunctions<Self> {
        WaveFunctions::of_real(self)
    }

    #[inline]
    fn even_waves(self) -> EvenWaves<Self> {
        EvenWaves::of_real(self)
    }

    #[inline(always)]
    fn is_negative(self) -> bool {
        self.hi < 0.0
    }

    #[inline(always)]
    fn vanishes(self) -> bool {
        self.hi == 0.0
    }

    #[inline]
    fn size(self) -> f64 {
        self.hi.abs()
    }

    #[inline(always)]
    fn times_power_of_two(self, exponent: i32) -> Self {
        DoubleDouble { hi: self.hi.times_power_of_two(exponent), lo: self.lo.times_power_of_two(exponent) }
    }

    #[inline(always)]
    fn scaled(self, power: f64) -> Self {
        DoubleDouble { hi: self.hi * power, lo: self.lo * power }
    }
}

impl Parameter for DoubleDouble {
    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline]
    fn to_f64(self) -> f64 {
        self.hi
    }

    #[inline]
    fn words(self) -> [f64; 2] {
        [self.hi, self.lo]
    }
}

impl Real for DoubleDouble {
    #[inline]
    fn sum_of_products(one: [Self; 2], other: [Self; 2]) -> Self {
        DoubleDouble::sum_of_products(one, other)
    }

    type Extended = Self;

    fn exp(self) -> Self {
        if self.hi.is_nan() || self.hi.abs() >= EXP_LIMIT {
            return DoubleDouble::from_double(Real::exp(self.hi));
        }
        let exponent = nearest_integer(self.hi * consts::LOG2_E);
        let x = self.minus_multiple(exponent, &LN_2);
        let e = DoubleDouble::ONE + (x + x * (x * taylor(x, 2, EVERY)));
        e.times_power_of_two(exponent as i32)
    }
}

impl core::ops::Mul<f64> for DoubleDouble {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        self * DoubleDouble::from_f64(factor)
    }
}

/// A double-double frequency of a system with `f64` parameters.
impl Frequency<f64> for DoubleDouble {
    type Meaning = RealFrequency;
    const IS_EXTENDED: bool = true;

    #[inline]
    fn lambda_squared(self) -> Self {
        -(self * self)
    }

    #[inline]
    fn omega(self) -> Self {
        self.abs()
    }

    #[inline]
    fn from_parameter(parameter: f64) -> Self {
        DoubleDouble::from_f64(parameter)
    }
}

impl Mul<f64> for Dual<Complex<DoubleDouble>> {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f64) -> Self {
        self * DoubleDouble::from_f64(factor)
    }
}

impl Frequency<f64> for Dual<Complex<DoubleDouble>> {
    type Meaning = ComplexEigenvalue;
    const IS_EXTENDED: bool = true;

    #[inline]
    fn lambda_squared(self) -> Self {
        self * self
    }

    #[inline]
    fn omega(self) -> Self {
        Frequency::<DoubleDouble>::omega(self)
    }

    #[inline]
    fn from_parameter(parameter: f64) -> Self {
        Frequency::<DoubleDouble>::from_parameter(DoubleDouble::from_f64(parameter))
    }
}

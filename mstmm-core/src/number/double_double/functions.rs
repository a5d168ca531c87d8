//! The elementary functions: reduction of the argument, then a Taylor series.

use crate::number::constants::{HALF_PI, LN_2, RECIPROCAL_FACTORIALS};
use crate::number::double_double::DoubleDouble;
use crate::number::dual::Dual;
use crate::number::even_waves::EvenWaves;
use crate::number::frequency::{ComplexEigenvalue, Frequency, Parameter, Real, RealFrequency};
use crate::number::products::{Operation, Products, on_machine};
use crate::number::scalar::{Scalar, single};
use crate::number::value::Value;
use crate::number::wave_functions::WaveFunctions;
use core::f64::consts;
use core::ops::Mul;
use num_complex::Complex;

/// Beyond it, an angle cannot be reduced by [`nearest_integer`] and the parts of `π/2`.
const ANGLE_LIMIT: f64 = 1_125_899_906_842_624.0;

/// Beyond it, the exponential is out of range on either side.
const EXP_LIMIT: f64 = 750.0;

/// Below it, `sh x` is summed up: the difference of two exponentials would cancel.
const SERIES_LIMIT: f64 = 1.0;

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

/// `1/n!`.
#[inline(always)]
fn reciprocal_factorial(n: usize) -> DoubleDouble {
    let [hi, lo, ..] = RECIPROCAL_FACTORIALS[n];
    DoubleDouble { hi, lo }
}

/// `Σ_k y^k / (stride·k + first)!` by Horner's rule; the small terms in `f64`, which is all they need.
#[inline(always)]
fn taylor<P: Products>(y: DoubleDouble, first: usize, terms: Terms) -> DoubleDouble {
    let coefficient = |k: usize| reciprocal_factorial(terms.stride * k + first);
    let mut tail = 0.0;
    for k in (terms.double..terms.all).rev() {
        tail = tail * y.hi + coefficient(k).hi;
    }
    let mut sum = DoubleDouble::from_double(tail);
    for k in (0..terms.double).rev() {
        sum = sum.times_by::<P>(y).added_to(coefficient(k));
    }
    sum
}

/// `sin x` and `cos x` for `y = -x²`, or `sh x` and `ch x` for `y = x²`. The leading term is added last, so that it
/// takes on no error but that of one rounding.
#[inline(always)]
fn sine_and_cosine<P: Products>(x: DoubleDouble, y: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let odd = x.times_by::<P>(y.times_by::<P>(taylor::<P>(y, 3, EVERY_OTHER)));
    let even = y.times_by::<P>(taylor::<P>(y, 2, EVERY_OTHER));
    (x.added_to(odd), DoubleDouble::ONE.added_to(even))
}

/// Sine and cosine of a number.
struct SineAndCosine(DoubleDouble);

impl Operation for SineAndCosine {
    type Output = (DoubleDouble, DoubleDouble);

    #[inline(always)]
    fn by<P: Products>(self) -> (DoubleDouble, DoubleDouble) {
        let SineAndCosine(x) = self;
        let quarters = nearest_integer(x.hi * consts::FRAC_2_PI);
        let x = x.minus_multiple::<P>(quarters, &HALF_PI[..4]);
        let (sin, cos) = sine_and_cosine::<P>(x, x.times_by::<P>(x).negated());
        match (quarters as i64) & 3 {
            0 => (sin, cos),
            1 => (cos, sin.negated()),
            2 => (sin.negated(), cos.negated()),
            _ => (cos.negated(), sin),
        }
    }
}

/// Hyperbolic sine and cosine of a number below [`SERIES_LIMIT`].
struct SmallHyperbolic(DoubleDouble);

impl Operation for SmallHyperbolic {
    type Output = (DoubleDouble, DoubleDouble);

    #[inline(always)]
    fn by<P: Products>(self) -> (DoubleDouble, DoubleDouble) {
        sine_and_cosine::<P>(self.0, self.0.times_by::<P>(self.0))
    }
}

/// The exponential of a number.
struct Exponential(DoubleDouble);

impl Operation for Exponential {
    type Output = DoubleDouble;

    #[inline(always)]
    fn by<P: Products>(self) -> DoubleDouble {
        let exponent = nearest_integer(self.0.hi * consts::LOG2_E);
        // three parts, of which multiples stay below 2^11
        let x = self.0.minus_multiple::<P>(exponent, &LN_2[..3]);
        let rest = x.times_by::<P>(x.times_by::<P>(taylor::<P>(x, 2, EVERY)));
        DoubleDouble::ONE.added_to(x.added_to(rest)).times_power_of_two(exponent as i32)
    }
}

/// The square root of a number: one Newton step from that of its first word, whose residual is exact.
struct Root(DoubleDouble, f64);

impl Operation for Root {
    type Output = DoubleDouble;

    #[inline(always)]
    fn by<P: Products>(self) -> DoubleDouble {
        let Root(square, root) = self;
        let residual = square.minus_multiple::<P>(root, &[root]);
        DoubleDouble::from_ordered_sum(root, residual.hi / (2.0 * root))
    }
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
        reciprocal_factorial(n)
    }

    fn sqrt(self) -> Self {
        let root = Scalar::sqrt(self.hi);
        if root == 0.0 || !root.is_finite() { DoubleDouble::from_double(root) } else { on_machine(Root(self, root)) }
    }

    /// NaN for angles of 2^50 and more.
    fn sin_cos(self) -> (Self, Self) {
        if self.hi.is_nan() || self.hi.abs() >= ANGLE_LIMIT {
            let nan = DoubleDouble::from_double(f64::NAN);
            return (nan, nan);
        }
        on_machine(SineAndCosine(self))
    }

    fn sinh_cosh(self) -> (Self, Self) {
        if self.hi.abs() < SERIES_LIMIT {
            return on_machine(SmallHyperbolic(self));
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

    /// Geometry often has ones, and units are powers of two, which round nothing.
    #[inline]
    fn times_real(self, real: Self) -> Self {
        const MANTISSA: u64 = (1 << 52) - 1;
        if real.lo == 0.0 && real.hi.to_bits() & MANTISSA == 0 { self.scaled(real.hi) } else { self * real }
    }

    #[inline(always)]
    fn less_product<P: Products>(self, a: Self, b: Self) -> Self {
        self.added_to(a.times_by::<P>(b).negated())
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
    fn complex_product(a: [Self; 2], b: [Self; 2]) -> [Self; 2] {
        DoubleDouble::times_complex(a, b)
    }

    #[inline]
    fn complex_quotient(dividend: [Self; 2], divisor: [Self; 2]) -> [Self; 2] {
        DoubleDouble::over_complex(dividend, divisor)
    }

    #[inline(always)]
    fn minus_complex_product<P: Products>([re, im]: [Self; 2], [first, second]: [[Self; 2]; 2]) -> [Self; 2] {
        let product = DoubleDouble::complex_product_by::<P>(first, second);
        [re.added_to(product[0].negated()), im.added_to(product[1].negated())]
    }

    type Extended = Self;
    type ExtendedComplex = Complex<Self>;

    fn exp(self) -> Self {
        if self.hi.is_nan() || self.hi.abs() >= EXP_LIMIT {
            return DoubleDouble::from_double(Real::exp(self.hi));
        }
        on_machine(Exponential(self))
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
    fn signed_omega(self) -> Self {
        self
    }

    #[inline]
    fn from_parameter(parameter: f64) -> Self {
        DoubleDouble::from_f64(parameter)
    }
}

/// Complex frequencies of systems with `f64` parameters, with and without a derivative.
macro_rules! complex_frequency {
    ($($number:ty;)*) => {$(
        impl Mul<f64> for $number {
            type Output = Self;

            #[inline]
            fn mul(self, factor: f64) -> Self {
                self * DoubleDouble::from_f64(factor)
            }
        }

        impl Frequency<f64> for $number {
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
            fn signed_omega(self) -> Self {
                Frequency::<DoubleDouble>::omega(self)
            }

            #[inline]
            fn from_parameter(parameter: f64) -> Self {
                Frequency::<DoubleDouble>::from_parameter(DoubleDouble::from_f64(parameter))
            }
        }
    )*};
}
complex_frequency! { Value<Complex<DoubleDouble>>; Dual<Complex<DoubleDouble>>; }

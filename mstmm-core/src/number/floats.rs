//! The real scalars `f64` and `f32`, and the one switch between `std` and `libm`.

use crate::number::double_double::DoubleDouble;
use crate::number::even_waves::EvenWaves;
use crate::number::exponent::power_of_two;
use crate::number::frequency::{Frequency, Parameter, Real, RealFrequency};
use crate::number::kernel;
use crate::number::scalar::{Scalar, single};
#[cfg(feature = "proof")]
use crate::number::value::Value;
use crate::number::wave_functions::WaveFunctions;
use num_complex::Complex;

impl<T: Real> Frequency<T> for T {
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
        parameter
    }
}

/// `1/n!`, each the quotient of an exact factorial or nearly so: 18! is the last that an `f64` holds, the relative error
/// of the others is below 10 eps, and they only enter terms below 1e-16.
const RECIPROCAL_FACTORIALS: [f64; 28] = {
    let mut table = [1.0; 28];
    let mut factorial = 1.0;
    let mut n = 1;
    while n < 28 {
        factorial *= n as f64;
        table[n] = 1.0 / factorial;
        n += 1;
    }
    table
};

/// `value · 2^exponent`.
#[inline(always)]
fn scale(value: f64, exponent: i32) -> f64 {
    if (-1022..=1023).contains(&exponent) { value * power_of_two(exponent) } else { scale_far(value, exponent) }
}

/// `value · 2^exponent` in steps that stay in range as long as the result does.
#[cold]
fn scale_far(mut value: f64, mut exponent: i32) -> f64 {
    while exponent > 1023 && value.is_finite() && value != 0.0 {
        value *= power_of_two(1023);
        exponent -= 1023;
    }
    while exponent < -969 && value != 0.0 {
        value *= power_of_two(-969);
        exponent += 969;
    }
    value * power_of_two(exponent.clamp(-1022, 1023))
}

/// Calls a function of the standard library or, without it, of `libm`. Without either `lib.rs` refuses the crate, and the function
/// is left out, so that the compiler reports nothing else.
macro_rules! elementary {
    ($std:expr, $libm:expr, $($argument:expr),+) => {{
        #[cfg(feature = "std")]
        let value = $std($($argument),+);
        #[cfg(all(feature = "libm", not(feature = "std")))]
        let value = $libm($($argument),+);
        #[cfg(not(any(feature = "libm", feature = "std")))]
        let (value, ..) = ($($argument),+,);
        value
    }};
}
pub(crate) use elementary;

/// Argument of a complex number.
#[inline]
pub(crate) fn argument(re: f64, im: f64) -> f64 {
    elementary!(f64::atan2, libm::atan2, im, re)
}

/// Natural logarithm of a positive number.
#[inline]
pub(crate) fn logarithm(x: f64) -> f64 {
    elementary!(f64::ln, libm::log, x)
}

/// Implements the real scalars for a primitive type, given its functions in `libm`.
macro_rules! real {
    ($type:ty, $extended:ty, $complex:ty, $terms:literal, $limit:literal, $sqrt:path, $sin:path, $cos:path, $sinh:path, $cosh:path, $exp:path $(, { $($exact:item)* } { $($kernel:item)* })?) => {
        impl Scalar for $type {
            single!();
            const EPSILON: f64 = <$type>::EPSILON as f64;
            const WAVE_LIMIT: f64 = $limit;
            const SERIES_TERMS: usize = $terms;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $type
            }

            #[inline(always)]
            fn reciprocal_factorial(n: usize) -> Self {
                RECIPROCAL_FACTORIALS[n] as $type
            }

            #[inline]
            fn sqrt(self) -> Self {
                elementary!(<$type>::sqrt, $sqrt, self)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                (elementary!(<$type>::sin, $sin, self), elementary!(<$type>::cos, $cos, self))
            }

            #[inline]
            fn sinh_cosh(self) -> (Self, Self) {
                (elementary!(<$type>::sinh, $sinh, self), elementary!(<$type>::cosh, $cosh, self))
            }

            // a call: in line its many constants and registers cost short models more than the call does
            #[inline(never)]
            fn wave_functions(self) -> WaveFunctions<Self> {
                WaveFunctions::of_real(self)
            }

            #[inline(never)]
            fn even_waves(self) -> EvenWaves<Self> {
                EvenWaves::of_real(self)
            }

            #[inline(always)]
            fn is_negative(self) -> bool {
                self < 0.0
            }

            #[inline(always)]
            fn vanishes(self) -> bool {
                self == 0.0
            }

            #[inline]
            fn size(self) -> f64 {
                f64::from(<$type>::abs(self))
            }

            #[inline(always)]
            fn times_power_of_two(self, exponent: i32) -> Self {
                scale(f64::from(self), exponent) as $type
            }

            #[inline(always)]
            fn scaled(self, power: f64) -> Self {
                (f64::from(self) * power) as $type
            }
        }

        impl Parameter for $type {
            #[inline]
            fn abs(self) -> Self {
                <$type>::abs(self)
            }

            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }

            $($($exact)*)?
        }

        impl Real for $type {
            type Extended = $extended;
            type ExtendedComplex = $complex;

            $($($kernel)*)?

            #[inline]
            fn exp(self) -> Self {
                elementary!(<$type>::exp, $exp, self)
            }

            #[inline]
            fn next_above(self) -> Self {
                self.next_up()
            }

            #[inline]
            fn next_below(self) -> Self {
                self.next_down()
            }

            #[inline(always)]
            fn waves_of_part(self) -> WaveFunctions<Self> {
                WaveFunctions::of_real(self)
            }
        }
    };
}

/// The extended precision of `f64`, and that of complex frequencies; without the feature `proof` there is none, and programs are small.
#[cfg(feature = "proof")]
type ExtendedOfDouble = DoubleDouble;
#[cfg(feature = "proof")]
type ExtendedComplex = Value<Complex<DoubleDouble>>;
#[cfg(not(feature = "proof"))]
type ExtendedOfDouble = f64;
#[cfg(not(feature = "proof"))]
type ExtendedComplex = Complex<f64>;

real! {
    f64, ExtendedOfDouble, ExtendedComplex, 6, 100.0, libm::sqrt, libm::sin, libm::cos, libm::sinh, libm::cosh, libm::exp,
    {
    #[inline]
    fn minus_product(self, [a, b, c]: [Self; 3]) -> [Self; 2] {
        let product = DoubleDouble::from_product(a, b) * DoubleDouble::from_f64(c);
        let words = (DoubleDouble::from_f64(self) - product).words();
        // parts of a product leave the range earlier than the product
        if words.iter().all(|word| word.is_finite()) { words } else { [self - a * b * c, 0.0] }
    }

    #[inline]
    fn difference(self, other: Self) -> [Self; 2] {
        let difference = self - other;
        if !Self::HAS_EXTENDED {
            return [difference, 0.0];
        }
        let exact = DoubleDouble::from_f64(self) - DoubleDouble::from_f64(other);
        [difference, (exact - DoubleDouble::from_f64(difference)).to_f64()]
    }
    }
    {
    const HAS_EXTENDED: bool = cfg!(feature = "proof");

    #[inline(always)]
    fn circular_and_hyperbolic(self) -> [Self; 4] {
        kernel::circular_and_hyperbolic(self)
    }

    #[inline(always)]
    fn hyperbolic(self) -> [Self; 2] {
        kernel::hyperbolic(self)
    }

    #[inline]
    fn circular(self) -> [Self; 2] {
        if self.abs() < kernel::LARGEST_ANGLE {
            return kernel::circular(self);
        }
        let (sin, cos) = Scalar::sin_cos(self);
        [sin, cos]
    }
    }
}
real! { f32, f32, Complex<f32>, 4, 20.0, libm::sqrtf, libm::sinf, libm::cosf, libm::sinhf, libm::coshf, libm::expf }

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_two_are_exact_up_to_the_ends_of_the_range() {
        assert_eq!(1.5_f64.times_power_of_two(10), 1536.0);
        assert_eq!(
            f64::MIN_POSITIVE.times_power_of_two(2045),
            f64::MIN_POSITIVE * 2f64.powi(1000) * 2f64.powi(1000) * 2f64.powi(45)
        );
        assert_eq!(1.0_f64.times_power_of_two(-1074), f64::from_bits(1));
        assert_eq!(2f64.powi(1000).times_power_of_two(-2000), 2f64.powi(-1000));
        assert_eq!(1.0_f64.times_power_of_two(5000), f64::INFINITY);
        assert_eq!(0.0_f64.times_power_of_two(5000), 0.0);
    }
}

//! The types of parameters and of frequencies.

use crate::number::products::Products;
use crate::number::scalar::{Scalar, Single};
use crate::number::wave_functions::WaveFunctions;
use core::ops::Mul;
use num_complex::Complex;
use num_traits::NumAssign;

/// A parameter of an element: a real number, or, in sweeps, those of several models in lanes.
///
/// It has no order: what holds for one model need not hold for another. [`check`](crate::Requirement::check) compares it with the range
/// that it must satisfy.
pub trait Parameter: Scalar {
    /// Absolute value.
    fn abs(self) -> Self;

    /// The nearest `f64`; of numbers in lanes the first.
    fn to_f64(self) -> f64;

    /// The number as the sum of two words, exactly.
    #[inline]
    fn words(self) -> [f64; 2] {
        [self.to_f64(), 0.0]
    }

    /// The sum of two words; in numbers of one word, rounded.
    #[inline]
    fn of_words([hi, lo]: [f64; 2]) -> Self {
        Self::from_f64(hi) + Self::from_f64(lo)
    }

    /// `self - a b c`, and what rounding takes from it, where there is an extended precision. The difference may be far smaller than the product.
    #[inline]
    fn minus_product(self, [a, b, c]: [Self; 3]) -> [Self; 2] {
        [self - a * b * c, Self::zero()]
    }

    /// `self - other`, and what rounding takes from it, where there is an extended precision.
    #[inline]
    fn difference(self, other: Self) -> [Self; 2] {
        [self - other, Self::zero()]
    }
}

/// A real scalar: the type of parameters and of natural frequencies.
#[diagnostic::on_unimplemented(
    note = "an element of your own is generic over `T: mstmm::number::Parameter`, since a sweep has the parameters of several models in one"
)]
pub trait Real: Parameter + Single + PartialOrd + NumAssign {
    /// The extended precision of this type; the type itself where there is none.
    type Extended: Real<Extended = Self::Extended> + Oscillation<Self>;

    /// A complex frequency in extended precision; the complex number itself where there is none.
    type ExtendedComplex: Oscillation<Self, Meaning = ComplexEigenvalue>
        + From<Complex<Self::Extended>>
        + Into<Complex<Self::Extended>>;

    /// Whether there is an extended precision.
    const HAS_EXTENDED: bool = false;

    /// Whether [words](Parameter::words) are all of a number: beside them a dual number has a derivative.
    const IS_ITS_WORDS: bool = true;

    /// Exponential function.
    fn exp(self) -> Self;

    /// The next number above a positive one; of numbers with more words than one, one that is an `EPSILON` above it.
    #[inline]
    fn next_above(self) -> Self {
        self + self * Self::from_f64(Self::EPSILON)
    }

    /// The next number below a positive one.
    #[inline]
    fn next_below(self) -> Self {
        self - self * Self::from_f64(Self::EPSILON)
    }

    /// The product of two complex numbers, given by their real and their imaginary parts.
    #[inline(always)]
    fn complex_product([re, im]: [Self; 2], [other_re, other_im]: [Self; 2]) -> [Self; 2] {
        [re * other_re - im * other_im, re * other_im + im * other_re]
    }

    /// The quotient of two complex numbers, given by their real and their imaginary parts.
    #[inline(always)]
    fn complex_quotient([re, im]: [Self; 2], [other_re, other_im]: [Self; 2]) -> [Self; 2] {
        let square = other_re * other_re + other_im * other_im;
        [(re * other_re + im * other_im) / square, (im * other_re - re * other_im) / square]
    }

    /// A complex number less a product, with the products of the machine.
    #[doc(hidden)]
    #[inline(always)]
    fn minus_complex_product<P: Products>([re, im]: [Self; 2], factors: [[Self; 2]; 2]) -> [Self; 2] {
        let [first, second] = factors;
        let product = Self::complex_product(first, second);
        [re - product[0], im - product[1]]
    }

    /// The wave functions of this number as a part of a complex one.
    #[inline(always)]
    fn waves_of_part(self) -> WaveFunctions<Self> {
        self.wave_functions()
    }

    /// `[sin, cos]` of an argument of any size.
    #[inline]
    fn circular(self) -> [Self; 2] {
        let (sin, cos) = self.sin_cos();
        [sin, cos]
    }

    /// `[sinh, cosh]` of an argument below [`WAVE_LIMIT`](Scalar::WAVE_LIMIT).
    #[inline]
    fn hyperbolic(self) -> [Self; 2] {
        let (sinh, cosh) = self.sinh_cosh();
        [sinh, cosh]
    }

    /// `[sin, cos, sinh, cosh]` of an argument below [`WAVE_LIMIT`](Scalar::WAVE_LIMIT).
    #[inline]
    fn circular_and_hyperbolic(self) -> [Self; 4] {
        let ((sin, cos), (sinh, cosh)) = (self.sin_cos(), self.sinh_cosh());
        [sin, cos, sinh, cosh]
    }
}

/// A scalar that stands for the frequency of a system with parameters of type `T`.
///
/// A real scalar is the angular frequency `ω` in rad/s, with `λ = iω`; a complex scalar is the eigenvalue `λ` in
/// 1/s itself. Undamped elements know the frequency by `λ²` alone, which is real in both cases.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a frequency for parameters of type `{T}`",
    note = "pass a real number for ω [rad/s], or a `Complex` number for λ [1/s]"
)]
pub trait Frequency<T>: Scalar + Mul<T, Output = Self> {
    /// The meaning of the scalar: [`RealFrequency`] or [`ComplexEigenvalue`].
    type Meaning;

    /// Whether this is the extended precision of the parameters. Steps then compute anew what `build` rounded.
    const IS_EXTENDED: bool = false;

    /// `λ²`: `-ω²` for a real frequency.
    fn lambda_squared(self) -> Self;

    /// `ω = -iλ`, to whose root the wave numbers of beams are proportional; `|ω|` for a real frequency.
    fn omega(self) -> Self;

    /// `ω = -iλ` with its sign, which tells forward whirl from backward whirl.
    fn signed_omega(self) -> Self;

    /// A parameter as a scalar of this type.
    fn from_parameter(parameter: T) -> Self;
}

/// The meaning of a real scalar: the angular frequency ω of an undamped motion.
#[derive(Clone, Copy, Debug)]
pub enum RealFrequency {}

/// The meaning of a complex scalar: the eigenvalue λ, whose real part says how the motion decays.
#[derive(Clone, Copy, Debug)]
pub enum ComplexEigenvalue {}

/// A meaning under which motions may decay, as dampers require.
///
/// A search for natural frequencies uses four scalars. They share one meaning, so that the compiler reports a damper once.
#[diagnostic::on_unimplemented(
    message = "a damped system has complex eigenvalues: it cannot be evaluated at a real frequency",
    label = "needs a complex λ, since something in the model is damped",
    note = "search its `eigenvalues` instead of `natural_frequencies`, count them with `count_in` instead of `count_below`",
    note = "pass `Complex::new(re, im)` for λ [1/s]; an undamped motion at ω is λ = iω, `Complex::new(0.0, omega)`",
    note = "name the model without damping above its struct, `#[undamped(QuietModel)]`: `model.undamped().build()` has natural frequencies"
)]
pub trait MayDecay {}

impl MayDecay for ComplexEigenvalue {}

/// A frequency that is the complex eigenvalue `λ` itself: what dashpots need.
pub trait ComplexFrequency<T>: Frequency<T> {}

impl<T, S> ComplexFrequency<T> for S
where
    S: Frequency<T>,
    S::Meaning: MayDecay,
{
}

/// The extended precision of a frequency `S` of a system with parameters of type `T`.
pub type ExtendedOf<S, T> = <S as Oscillation<T>>::Extended;

/// A frequency at which motions are computed.
pub trait Oscillation<T: Real>: Frequency<T> + Single {
    /// The frequency in extended precision; the type itself where there is none.
    type Extended: Oscillation<T>;

    /// Whether there is an extended precision.
    const HAS_EXTENDED: bool;

    /// The number in extended precision.
    fn to_extended(self) -> Self::Extended;

    /// The number nearest to one in extended precision.
    fn from_extended(value: Self::Extended) -> Self;

    /// The number as a complex one.
    fn to_complex(self) -> Complex<T>;

    /// The number from its complex form.
    fn from_complex(value: Complex<T>) -> Self;

    /// The modulus, |ω| or |λ|.
    #[inline]
    fn modulus(self) -> f64 {
        modulus(self.to_complex()).to_f64()
    }

    /// The complex conjugate; a real frequency is its own.
    fn conjugate(self) -> Self;

    /// The frequency of a steady vibration at ω [rad/s]: ω itself or iω.
    fn of_omega(omega: T) -> Self;

    /// Derivative of λ² with respect to the frequency: `-2ω` or `2λ`.
    fn slope_of_lambda_squared(self) -> Self;

    /// λ, which multiplies a damping form; 0 for a real frequency, whose systems have no dampers.
    fn lambda(self) -> Self;

    /// Points x around this frequency x0, each with a weight w: `Σ w (x - x0) f(x)` is the residue of f at a simple pole x0. The
    /// regular part of f enters with the eighth power of the distance.
    fn around(self, distance: T) -> [(Self, Self); 8];
}

/// The larger of two numbers.
#[inline]
pub(crate) fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The smaller of two numbers; the second if the first is not a number.
#[inline]
pub(crate) fn smaller<T: Real>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// Modulus of a complex number.
#[inline]
pub(crate) fn modulus<T: Real>(z: Complex<T>) -> T {
    (z.re * z.re + z.im * z.im).sqrt()
}

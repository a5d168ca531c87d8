//! What parameters are, and what a frequency is.

use crate::number::scalar::Scalar;
use core::ops::Mul;
use num_complex::Complex;
use num_traits::NumAssign;

/// A real scalar: the type of parameters and of natural frequencies.
pub trait Real: Scalar + NumAssign + PartialOrd {
    /// The nearest `f64`.
    fn to_f64(self) -> f64;

    /// The arithmetic that judges the rounding of this one; the type itself where there is none. It has no other judge.
    type Extended: Real<Extended = Self::Extended> + Oscillation<Self>;

    /// Whether there is a judge.
    const HAS_EXTENDED: bool = false;

    /// `self - a b c`, rounded once where there is more to compute with: what is left may be far smaller than the product.
    fn minus_product(self, [a, b, c]: [Self; 3]) -> Self {
        self - a * b * c
    }

    /// Exponential function.
    fn exp(self) -> Self;

    /// `[sin, cos]` of an argument of any size.
    #[inline]
    fn circular(self) -> [Self; 2] {
        let (sin, cos) = self.sin_cos();
        [sin, cos]
    }

    /// `[sin, cos, sinh, cosh]` of an argument below [`WAVE_LIMIT`](Scalar::WAVE_LIMIT).
    #[inline]
    fn circular_and_hyperbolic(self) -> [Self; 4] {
        let ((sin, cos), (sinh, cosh)) = (self.sin_cos(), self.sinh_cosh());
        [sin, cos, sinh, cosh]
    }

    /// Absolute value.
    fn abs(self) -> Self;
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
    /// What the scalar stands for: [`RealFrequency`] or [`ComplexEigenvalue`].
    type Meaning;

    /// Whether it judges the rounding of the parameters' arithmetic: what was rounded in that is computed anew.
    const IS_EXTENDED: bool = false;

    /// `λ²`: `-ω²` for a real frequency.
    fn lambda_squared(self) -> Self;

    /// `ω = -iλ`, to whose root the wave numbers of beams are proportional; `|ω|` for a real frequency.
    fn omega(self) -> Self;

    /// A parameter as a scalar of this type.
    fn from_parameter(parameter: T) -> Self;
}

/// The meaning of a real scalar: the angular frequency ω of an undamped motion.
#[derive(Clone, Copy, Debug)]
pub enum RealFrequency {}

/// The meaning of a complex scalar: the eigenvalue λ, whose real part says how the motion decays.
#[derive(Clone, Copy, Debug)]
pub enum ComplexEigenvalue {}

/// Whether motions of this meaning may decay, as dampers make them.
///
/// Four scalars take part in a search for natural frequencies. A damper objects to what they mean, which is one thing: the
/// compiler says it once.
#[diagnostic::on_unimplemented(
    message = "a system with a damper has complex eigenvalues: it cannot be evaluated at a real frequency",
    label = "needs a complex λ, since there is a damper in the model",
    note = "search its `eigenvalues` instead of `natural_frequencies`, count them with `count_in` instead of `count_below`",
    note = "pass `Complex::new(re, im)` for λ [1/s]; an undamped motion at ω is λ = iω, `Complex::new(0.0, omega)`"
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

/// The arithmetic that judges a frequency of a system with parameters of type `T`.
pub type ExtendedOf<S, T> = <S as Oscillation<T>>::Extended;

/// A frequency at which motions are computed.
pub trait Oscillation<T: Real>: Frequency<T> {
    /// The same in the arithmetic that judges the rounding of this one; the type itself where there is none.
    type Extended: Oscillation<T>;

    /// Whether there is a judge.
    const HAS_EXTENDED: bool;

    /// The number in the judging arithmetic.
    fn to_extended(self) -> Self::Extended;

    /// Back from the judging arithmetic.
    fn from_extended(value: Self::Extended) -> Self;

    /// The number as a complex one.
    fn to_complex(self) -> Complex<T>;

    /// Back from a complex number, which is real where this one is.
    fn from_complex(value: Complex<T>) -> Self;

    /// The modulus, |ω| or |λ|.
    fn modulus(self) -> f64 {
        modulus(self.to_complex()).to_f64()
    }

    /// The complex conjugate; of a real frequency itself.
    fn conjugate(self) -> Self;

    /// The frequency of a steady vibration at ω [rad/s]: ω itself or iω.
    fn of_omega(omega: T) -> Self;

    /// Derivative of λ² with respect to the frequency: `-2ω` or `2λ`.
    fn slope_of_lambda_squared(self) -> Self;

    /// λ, which a damping form multiplies; a real frequency has none.
    fn lambda(self) -> Self;

    /// Points about a frequency at a distance, each with the weight of `(x - x0) f(x)` in the residue of f at its simple pole
    /// x0: the rest of f enters with the eighth power of the distance.
    fn around(self, distance: T) -> [(Self, Self); 8];
}

/// The larger of two numbers.
pub(crate) fn larger<T: Real>(a: T, b: T) -> T {
    if a > b { a } else { b }
}

/// The smaller of two numbers; the second if the first is not a number.
pub(crate) fn smaller<T: Real>(a: T, b: T) -> T {
    if a < b { a } else { b }
}

/// Modulus of a complex number.
pub(crate) fn modulus<T: Real>(z: Complex<T>) -> T {
    (z.re * z.re + z.im * z.im).sqrt()
}

//! Scalars: what matrices are made of, what parameters are, and what a frequency is.

mod complex;
mod double_double;
mod dual;
mod kernel;
mod oscillation;
mod real;
mod waves;

pub(crate) use complex::modulus;
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use oscillation::{JudgeOf, Oscillation};
pub(crate) use real::{argument, elementary};
pub use waves::{WaveFunctions, WaveProducts};

use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{NumAssign, One, Zero};

/// A number that transfer matrices can be made of: real or complex, of any precision.
///
/// The functions are those that the elements need; all are analytic, so that real and complex evaluation share
/// every formula.
pub trait Scalar:
    nalgebra::Scalar
    + Copy
    + Default
    + Zero
    + One
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
{
    /// Which of the formulas for waves are taken.
    const BRANCHES: Branches = Branches::All;

    /// The unit in the last place of 1.
    const EPSILON: f64;

    /// Beyond this size `exp(-2z)` does not count beside 1, while `exp(z)` is still far from overflow.
    const WAVE_LIMIT: f64;

    /// Number of terms after which a Taylor series in `z⁴`, `|z⁴| <= 1`, is exact to rounding.
    const SERIES_TERMS: usize;

    /// Number of steps up to which all steps of a pass stand in line: faster, but slower to compile.
    const LONGEST_IN_LINE: usize = 24;

    /// The scalar nearest to `value`.
    fn from_f64(value: f64) -> Self;

    /// `1/n!`, for `n` up to four times the number of series terms.
    fn reciprocal_factorial(n: usize) -> Self;

    /// Principal square root.
    fn sqrt(self) -> Self;

    /// The same where [`is_plain`](Self::is_plain): no branches.
    #[inline(always)]
    fn moderate_sqrt(self) -> Self {
        self.sqrt()
    }

    /// Whether squares of all parts that are not zero are far from the ends of the range.
    #[inline(always)]
    fn is_plain(self) -> bool {
        let size = self.size();
        (size > 1e-100) & (size < 1e100)
    }

    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);

    /// Hyperbolic sine and cosine.
    fn sinh_cosh(self) -> (Self, Self);

    /// Products of the circular and hyperbolic functions of `z`, scaled so that nothing overflows.
    fn wave_products(self) -> WaveProducts<Self>;

    /// The same for a size below [`WAVE_LIMIT`](Self::WAVE_LIMIT), where nothing needs to be scaled: no branches.
    fn moderate_wave_products(self) -> WaveProducts<Self>;

    /// Largest modulus among the real components, of a dual number those of its value: what pivots and branches compare. NaN if any
    /// of them is.
    fn size(self) -> f64;

    /// `self · 2^exponent`, exact unless it leaves the range of the type.
    fn times_power_of_two(self, exponent: i32) -> Self;

    /// The same for an exponent from -1022 to 1023: no branches.
    #[inline(always)]
    fn times_normal_power_of_two(self, exponent: i32) -> Self {
        self.times_power_of_two(exponent)
    }

    /// The number itself, or NaN where the condition does not hold: without a branch.
    fn or_nan(self, condition: bool) -> Self;

    /// The number itself. One that knows no branches is NaN where the condition does not hold: straight-line code does not
    /// hold there either.
    #[inline(always)]
    fn provided(self, _condition: bool) -> Self {
        self
    }

    /// The whole number in a number that is not negative.
    #[inline(always)]
    fn whole(number: f64) -> u64 {
        number as u64
    }

    /// Entries that may all be multiplied by a power of two, shifted into the middle of the range by their size, and the
    /// power taken out.
    #[inline(always)]
    fn in_range<const N: usize>(entries: [Self; N], size: f64) -> ([Self; N], i32) {
        if is_moderate(size) {
            return (entries, 0);
        }
        let shift = excess(size);
        (entries.map(|entry| entry.times_power_of_two(-shift)), shift)
    }
}

/// A number of which many stand in columns, each of its real parts in one of its own: what blocks are made of.
pub trait InColumns: Scalar {
    /// So many numbers.
    type Columns<const N: usize>: Copy + fmt::Debug;

    /// The same number everywhere.
    fn columns<const N: usize>(self) -> Self::Columns<N>;

    /// The number in a place.
    fn get<const N: usize>(columns: &Self::Columns<N>, place: usize) -> Self;

    /// Puts the number in a place.
    fn put<const N: usize>(self, columns: &mut Self::Columns<N>, place: usize);
}

/// Which of an element's formulas a scalar knows: all of them, or those of straight-line code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branches {
    /// Each value takes the formulas that are right for it.
    All,
    /// Those for waves that are neither short nor so many that they have to be scaled.
    Waves,
    /// The series for a length of less than a wave.
    Series,
}

/// Where entries are shifted back into the middle of the range.
const LARGE: f64 = 1e60;
const SMALL: f64 = 1e-60;

/// Whether entries of this size are in the middle of the range.
#[inline(always)]
pub(crate) fn is_moderate(size: f64) -> bool {
    (SMALL < size) & (size < LARGE)
}

/// The power of two to take out of entries beyond the middle of the range; none out of zeros and what is not finite.
#[cold]
fn excess(size: f64) -> i32 {
    if size == 0.0 || !size.is_finite() { 0 } else { crate::scaled::binary_exponent(size) }
}

/// A real scalar: the type of parameters and of natural frequencies.
pub trait Real: Scalar + NumAssign + PartialOrd {
    /// The nearest `f64`.
    fn to_f64(self) -> f64;

    /// The arithmetic that judges the rounding of this one; the type itself where there is none. It has no other judge.
    type Judge: Real<Judge = Self::Judge> + Oscillation<Self>;

    /// Whether there is a judge.
    const HAS_JUDGE: bool = false;

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
    const JUDGES: bool = false;

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

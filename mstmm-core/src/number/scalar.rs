//! Scalars: the entries of matrices and states.

use crate::number::exponent::binary_exponent;
use crate::number::wave_functions::WaveFunctions;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

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
    /// The formulas for waves that this number computes.
    const BRANCHES: Branches = Branches::All;

    /// The number without its derivative.
    type Plain: Scalar;

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

    /// Principal square root without branches, of a number that [`is_plain`](Self::is_plain).
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

    /// Sine, cosine and their hyperbolic kin of this number, scaled so that nothing overflows.
    fn wave_functions(self) -> WaveFunctions<Self>;

    /// Wave functions without branches, for a size below [`WAVE_LIMIT`](Self::WAVE_LIMIT), where nothing needs to be scaled.
    fn moderate_wave_functions(self) -> WaveFunctions<Self>;

    /// Functions of this number whose slopes follow from their values, as those of sines, waves and their products do. `values` and
    /// `slopes` take the number without its derivative; the second result of `values` is returned unchanged.
    fn functions<const N: usize, R>(
        self,
        values: impl FnOnce(Self::Plain) -> ([Self::Plain; N], R),
        slopes: impl FnOnce([Self::Plain; N]) -> [Self::Plain; N],
    ) -> ([Self; N], R);

    /// A constant: its derivative is zero.
    fn constant(value: Self::Plain) -> Self;

    /// Whether a real number is below zero; complex ones have no order.
    fn is_negative(self) -> bool;

    /// Largest modulus among the real components, of a dual number those of its value; NaN if any of them is. Pivots and branches
    /// compare it.
    fn size(self) -> f64;

    /// `self · 2^exponent`, exact unless it leaves the range of the type.
    fn times_power_of_two(self, exponent: i32) -> Self;

    /// `self · 2^exponent` without branches, for an exponent from -1022 to 1023.
    #[inline(always)]
    fn times_normal_power_of_two(self, exponent: i32) -> Self {
        self.times_power_of_two(exponent)
    }

    /// The number itself, or NaN where the condition does not hold, without a branch.
    fn or_nan(self, condition: bool) -> Self;

    /// The number itself; a branch-free number is NaN where the condition does not hold, since its formula does not hold there
    /// either.
    #[inline(always)]
    fn valid_if(self, _condition: bool) -> Self {
        self
    }

    /// The whole part of a number that is not negative.
    #[inline(always)]
    fn whole(number: f64) -> u64 {
        number as u64
    }

    /// Shifts entries by a common power of two into the middle of the range, where their size is beyond it. Returns them with
    /// the power taken out.
    #[inline(always)]
    fn in_range<const N: usize>(entries: [Self; N], size: f64) -> ([Self; N], i32) {
        if is_moderate(size) {
            return (entries, 0);
        }
        let shift = excess(size);
        (entries.map(|entry| entry.times_power_of_two(-shift)), shift)
    }
}

/// The formulas for waves that a scalar computes: all of them, or one of the two without branches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branches {
    /// All formulas; each value takes the one that suits it.
    All,
    /// The closed forms for waves that are neither short nor so many that they have to be scaled.
    Waves,
    /// The series for a length of less than a wave.
    Series,
}

/// Sizes beyond which entries are shifted back into the middle of the range.
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
    if size == 0.0 || !size.is_finite() { 0 } else { binary_exponent(size) }
}

//! Scalars: the entries of matrices and states.

use crate::number::even_waves::EvenWaves;
use crate::number::products::{Operation, Products, Split, on_machine};
use crate::number::truth::{Size, Truth};
use crate::number::wave_functions::{WaveFunctions, WaveProducts};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};
use num_traits::{One, Zero};

/// Number of steps up to which a pass stands in line for numbers in lanes, and for most others.
pub const LONGEST_IN_LANES: usize = 24;

/// A number that transfer matrices can be made of: real or complex, of any precision, alone or in lanes.
///
/// The functions are those that the elements need; all are analytic, so that real and complex evaluation share
/// every formula. Comparisons give the scalar's own [`Truth`](Scalar::Truth), and [`select`](Scalar::select) takes it, so that numbers in
/// lanes share every formula, too.
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
    /// What a comparison gives.
    type Truth: Truth;

    /// The type of sizes.
    type Size: Size<Truth = Self::Truth>;

    /// Whether this is a number of several lanes. What holds for one number only then is NaN in lanes, and such a lane is evaluated
    /// alone.
    const IN_LANES: bool = false;

    /// The unit in the last place of 1.
    const EPSILON: f64;

    /// Beyond this size `exp(-2z)` does not count beside 1, while `exp(z)` is still far from overflow.
    const WAVE_LIMIT: f64;

    /// Number of terms after which a Taylor series in `z⁴`, `|z⁴| <= 1`, is exact to rounding.
    const SERIES_TERMS: usize;

    /// Number of steps up to which all steps of a pass stand in line: faster, but slower to compile.
    const LONGEST_IN_LINE: usize = LONGEST_IN_LANES;

    /// The scalar nearest to `value`.
    fn from_f64(value: f64) -> Self;

    /// `1/n!`, for `n` up to four times the number of series terms.
    fn reciprocal_factorial(n: usize) -> Self;

    /// Principal square root.
    fn sqrt(self) -> Self;

    /// Sine and cosine.
    fn sin_cos(self) -> (Self, Self);

    /// Hyperbolic sine and cosine.
    fn sinh_cosh(self) -> (Self, Self);

    /// Sine, cosine and their hyperbolic kin of this number, scaled so that nothing overflows.
    fn wave_functions(self) -> WaveFunctions<Self>;

    /// `cosh √κ` and `sinh √κ / √κ` of this number κ, of either sign, scaled so that nothing overflows. In lanes nothing is scaled, and what would
    /// overflow is NaN.
    fn even_waves(self) -> EvenWaves<Self>;

    /// The products of circular and hyperbolic functions of this number.
    #[inline(always)]
    fn wave_products(self) -> WaveProducts<Self> {
        WaveProducts::of(self.wave_functions())
    }

    /// The same products of `z`, given `z⁴`, for `|z| <= 1`: ch c, (ch s + sh c)/z, sh s/z², (ch s - sh c)/z³, (1 - ch c)/z⁴.
    #[inline(always)]
    fn short_wave_products(self) -> [Self; 5] {
        short_wave_products(self)
    }

    /// The first number where the truth holds, else the second.
    fn select(truth: Self::Truth, first: Self, second: Self) -> Self;

    /// Whether a real number is below zero; complex ones have no order.
    fn is_negative(self) -> Self::Truth;

    /// Whether it is the constant zero, whose derivative vanishes as well.
    #[inline(always)]
    fn is_constant_zero(self) -> bool {
        self.is_zero()
    }

    /// The product, of complex numbers with few roundings.
    #[inline(always)]
    #[must_use]
    fn product(self, other: Self) -> Self {
        self * other
    }

    /// The number less a product, with the products of the machine. Both ways give the same bits.
    #[doc(hidden)]
    #[inline(always)]
    #[must_use]
    fn less_product<P: Products>(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    /// The quotient, of complex numbers with few roundings.
    #[inline(always)]
    #[must_use]
    fn quotient(self, other: Self) -> Self {
        self / other
    }

    /// The product with a number of geometry, which has neither an imaginary part nor a derivative.
    #[inline(always)]
    #[must_use]
    fn times_real(self, real: Self) -> Self {
        self * real
    }

    /// Whether the number is zero, a dual one its value.
    fn vanishes(self) -> Self::Truth;

    /// Largest modulus among the real components, of a dual number those of its value; NaN if any of them is. Pivots and branches
    /// compare it.
    fn size(self) -> Self::Size;

    /// `self · 2^exponent`, exact unless it leaves the range of the type.
    fn times_power_of_two(self, exponent: i32) -> Self;

    /// The number times a power of two that is given as a number: one product, where several have the same.
    fn scaled(self, power: f64) -> Self;

    /// The number itself; in lanes it is NaN where the condition does not hold, since its formula does not hold there either.
    #[inline(always)]
    fn valid_if(self, _condition: Self::Truth) -> Self {
        self
    }

    /// Shifts entries by a common power of two into the middle of the range, where their size is beyond it. Returns them with
    /// the power taken out. In lanes the first and the last one are NaN there.
    #[inline(always)]
    fn in_range<const N: usize>(mut entries: [Self; N], size: Self::Size) -> ([Self; N], i32) {
        let (shift, is_kept) = size.excess();
        if shift != 0 {
            return (shifted(entries, -shift), shift);
        }
        entries[0] = entries[0].valid_if(is_kept);
        entries[N - 1] = entries[N - 1].valid_if(is_kept);
        (entries, 0)
    }
}

/// Entries times a power of two.
#[cold]
fn shifted<S: Scalar, const N: usize>(mut entries: [S; N], exponent: i32) -> [S; N] {
    // `array::map` is ten functions to compile, for each scalar
    for entry in &mut entries {
        *entry = entry.times_power_of_two(exponent);
    }
    entries
}

/// `[C, 2B, 2F, 2D, 2E]` of a beam's second compound as entire functions of `x = z⁴`, for `|x| <= 1`:
/// `ch c, (ch s + sh c)/z, sh s/z², (ch s - sh c)/z³, (1 - ch c)/z⁴`.
#[inline(always)]
pub(crate) fn short_wave_products<S: Scalar>(x: S) -> [S; 5] {
    let y = -twice(twice(x));
    let mut series_of = [y; 5];
    let mut first = 0;
    // a loop and no closure, which would stand in another function than the lanes of vectors need
    while first < 5 {
        series_of[first] = series(y, first, 4);
        first += 1;
    }
    let [c, b, f, d, e] = series_of;
    [c, twice(b), twice(f), twice(twice(d)), twice(twice(e))]
}

/// [`short_wave_products`], each with its derivative, which costs a product per term where a dual number would take two.
#[inline(always)]
pub(crate) fn short_wave_products_and_slopes<S: Scalar>(x: S) -> [[S; 2]; 5] {
    let y = -twice(twice(x));
    let mut all = [[y; 2]; 5];
    for (first, both) in all.iter_mut().enumerate() {
        let last = S::SERIES_TERMS - 1;
        let mut slope = S::reciprocal_factorial(4 * last + first);
        let mut sum = slope * y + S::reciprocal_factorial(4 * (last - 1) + first);
        for k in (0..last - 1).rev() {
            slope = slope * y + sum;
            sum = sum * y + S::reciprocal_factorial(4 * k + first);
        }
        // in the loop, and not behind it for each of ten numbers: programs are smaller
        let factor = FACTORS[first];
        *both = [sum.scaled(factor), slope.scaled(-4.0 * factor)];
    }
    all
}

/// Factors of the series of [`short_wave_products`].
const FACTORS: [f64; 5] = [1.0, 2.0, 2.0, 4.0, 4.0];

/// `2x`, exact, and for a complex number less than a product.
#[inline(always)]
pub(crate) fn twice<S: Scalar>(x: S) -> S {
    x + x
}

/// `Σ_k x^k / (stride·k + first)!` by Horner's rule, from the last term that counts.
#[inline(always)]
pub(crate) fn series<S: Scalar>(x: S, first: usize, stride: usize) -> S {
    let last = S::SERIES_TERMS * 4 / stride - 1;
    let mut sum = S::reciprocal_factorial(stride * last + first);
    for k in (0..last).rev() {
        sum = sum * x + S::reciprocal_factorial(stride * k + first);
    }
    sum
}

/// Whether a number is made of double-doubles, of which each operation is many: it has more digits than an `f64`.
#[inline(always)]
pub(crate) fn is_long<S: Scalar>() -> bool {
    S::EPSILON < f64::EPSILON
}

/// Does work on numbers: on the instruction set of the machine where each product is many operations.
#[inline(always)]
pub(crate) fn with_products<S: Scalar, O: Operation>(operation: O) -> O::Output {
    if is_long::<S>() { on_machine(operation) } else { operation.by::<Split>() }
}

/// A scalar that is one number, whose comparisons are plain truths.
pub trait Single: Scalar<Truth = bool, Size = f64> {}

impl<S: Scalar<Truth = bool, Size = f64>> Single for S {}

/// What every scalar that is one number has in common.
macro_rules! single {
    () => {
        type Truth = bool;
        type Size = f64;

        #[inline(always)]
        fn select(truth: bool, first: Self, second: Self) -> Self {
            if truth { first } else { second }
        }
    };
}
pub(crate) use single;

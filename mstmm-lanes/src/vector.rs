//! Vectors of `f64` in registers.

use core::fmt::Debug;

/// A vector of `f64` in a register of some instruction set. All operations round as those of one `f64` do; none is fused but
/// [`product_error`](Vector::product_error).
///
/// A value may exist only in code that runs since the machine was found to have the instruction set, as
/// [`Task`](crate::Task) does: elsewhere its operations are undefined. [`Plain`](crate::Plain) numbers may exist everywhere.
pub trait Vector: Copy + Debug + 'static {
    /// Number of lanes.
    const LANES: usize;

    /// A truth per lane.
    type Mask: Copy + Debug;

    /// A number in all lanes.
    fn splat(number: f64) -> Self;
    /// The first numbers of a slice; the last one fills the lanes beyond its end.
    fn load(numbers: &[f64]) -> Self;
    /// The lanes as numbers.
    fn store(self, numbers: &mut [f64]);
    /// The sum in each lane.
    fn sum(self, other: Self) -> Self;
    /// The difference in each lane.
    fn difference(self, other: Self) -> Self;
    /// The product in each lane.
    fn product(self, other: Self) -> Self;
    /// The product less its rounded value, rounded once: exactly, unless it underflows.
    fn product_error(self, other: Self, product: Self) -> Self;
    /// The quotient in each lane.
    fn quotient(self, other: Self) -> Self;
    /// The number of opposite sign.
    fn negated(self) -> Self;
    /// The absolute value.
    fn magnitude(self) -> Self;
    /// The square root.
    fn root(self) -> Self;
    /// The greatest whole number that is not greater.
    fn floor(self) -> Self;
    /// Whether a number is less than another; false where one is NaN.
    fn is_less(self, other: Self) -> Self::Mask;
    /// Whether the sign is negative.
    fn has_minus(self) -> Self::Mask;
    /// Whether a number is zero, of either sign.
    fn is_nought(self) -> Self::Mask;
    /// Whether the last bit is set.
    fn last_bit(self) -> Self::Mask;
    /// The first number where the truth holds, else the second.
    fn select(truth: Self::Mask, first: Self, second: Self) -> Self;
    /// The number with its sign changed where the second last bit of `bits + added` is set.
    fn signed_by(self, bits: Self, added: i64) -> Self;
    /// `2^(k - 1)` and `2^(-k - 1)` for the integer k in the last bits.
    fn powers(self) -> [Self; 2];
    /// Both truths.
    fn both(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// At least one of two truths.
    fn either(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// Exactly one of two truths.
    fn one_of(a: Self::Mask, b: Self::Mask) -> Self::Mask;
    /// The opposite truth.
    fn not(a: Self::Mask) -> Self::Mask;
    /// A truth in all lanes.
    fn mask(truth: bool) -> Self::Mask;
    /// A bit per lane, that of the first lane last.
    fn bits(mask: Self::Mask) -> u8;
    /// Does a part in a function of its own, which is compiled for the instruction set.
    fn call<P: Part>(part: P) -> P::Output;
}

/// A part of a task that is called, since it would be long in line, and compiled again wherever it stands. All functions that it calls
/// have to stand in line. Vectors are passed in memory, to it and back.
pub trait Part {
    /// The result.
    type Output;

    /// Does it. Mark it `#[inline(always)]`.
    fn run(self) -> Self::Output;
}

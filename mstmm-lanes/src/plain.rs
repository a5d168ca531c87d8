//! Eight numbers in an array, for parameters: they exist on every machine, and are loaded where a vector needs them.

use crate::vector::{Part, Vector};

/// Eight numbers in an array, aligned as the vectors that load them.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Plain([f64; 8]);

/// What a function makes of each lane.
#[inline(always)]
fn each<A: Copy>(of: impl Fn(usize) -> A) -> [A; 8] {
    core::array::from_fn(of)
}

impl Plain {
    /// The numbers.
    #[inline(always)]
    pub fn numbers(&self) -> &[f64; 8] {
        &self.0
    }

    /// What a function makes of the bits of each number.
    #[inline(always)]
    fn of_bits(self, of: impl Fn(u64) -> u64) -> Self {
        Plain(each(|k| f64::from_bits(of(self.0[k].to_bits()))))
    }
}

impl Vector for Plain {
    const LANES: usize = 8;
    type Mask = [bool; 8];

    #[inline]
    fn splat(number: f64) -> Self {
        Plain([number; 8])
    }

    #[inline]
    fn load(numbers: &[f64]) -> Self {
        let last = numbers.last().copied().unwrap_or(0.0);
        Plain(each(|k| numbers.get(k).copied().unwrap_or(last)))
    }

    #[inline]
    fn store(self, numbers: &mut [f64]) {
        numbers.iter_mut().zip(self.0).for_each(|(place, number)| *place = number);
    }

    #[inline]
    fn sum(self, other: Self) -> Self {
        Plain(each(|k| self.0[k] + other.0[k]))
    }

    #[inline]
    fn difference(self, other: Self) -> Self {
        Plain(each(|k| self.0[k] - other.0[k]))
    }

    #[inline]
    fn product(self, other: Self) -> Self {
        Plain(each(|k| self.0[k] * other.0[k]))
    }

    #[inline]
    fn product_error(self, other: Self, product: Self) -> Self {
        Plain(each(|lane| self.0[lane].mul_add(other.0[lane], -product.0[lane])))
    }

    #[inline]
    fn quotient(self, other: Self) -> Self {
        Plain(each(|k| self.0[k] / other.0[k]))
    }

    #[inline]
    fn negated(self) -> Self {
        Plain(each(|k| -self.0[k]))
    }

    #[inline]
    fn magnitude(self) -> Self {
        Plain(each(|k| self.0[k].abs()))
    }

    #[inline]
    fn root(self) -> Self {
        Plain(each(|k| self.0[k].sqrt()))
    }

    #[inline]
    fn floor(self) -> Self {
        Plain(each(|k| self.0[k].floor()))
    }

    #[inline]
    fn is_less(self, other: Self) -> [bool; 8] {
        each(|k| self.0[k] < other.0[k])
    }

    #[inline]
    fn has_minus(self) -> [bool; 8] {
        each(|k| self.0[k].is_sign_negative())
    }

    #[inline]
    fn is_nought(self) -> [bool; 8] {
        each(|k| self.0[k] == 0.0)
    }

    #[inline]
    fn last_bit(self) -> [bool; 8] {
        each(|k| self.0[k].to_bits() & 1 == 1)
    }

    #[inline]
    fn select(truth: [bool; 8], first: Self, second: Self) -> Self {
        Plain(each(|k| if truth[k] { first.0[k] } else { second.0[k] }))
    }

    #[inline]
    fn signed_by(self, bits: Self, added: i64) -> Self {
        let sign = |k: usize| (bits.0[k].to_bits().wrapping_add_signed(added) & 2) << 62;
        Plain(each(|k| f64::from_bits(self.0[k].to_bits() ^ sign(k))))
    }

    #[inline]
    fn powers(self) -> [Self; 2] {
        let half = 1022_u64 << 52;
        [self.of_bits(|bits| half.wrapping_add(bits << 52)), self.of_bits(|bits| half.wrapping_sub(bits << 52))]
    }

    #[inline]
    fn both(a: [bool; 8], b: [bool; 8]) -> [bool; 8] {
        each(|k| a[k] & b[k])
    }

    #[inline]
    fn either(a: [bool; 8], b: [bool; 8]) -> [bool; 8] {
        each(|k| a[k] | b[k])
    }

    #[inline]
    fn one_of(a: [bool; 8], b: [bool; 8]) -> [bool; 8] {
        each(|k| a[k] ^ b[k])
    }

    #[inline]
    fn not(a: [bool; 8]) -> [bool; 8] {
        each(|k| !a[k])
    }

    #[inline]
    fn mask(truth: bool) -> [bool; 8] {
        [truth; 8]
    }

    #[inline]
    fn bits(mask: [bool; 8]) -> u8 {
        mask.iter().rev().fold(0, |bits, truth| bits << 1 | u8::from(*truth))
    }

    #[inline]
    fn call<P: Part>(part: P) -> P::Output {
        part.run()
    }
}

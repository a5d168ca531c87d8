//! Numbers with a stated bound of the rounding of each operation: two words, and for tests one.

use crate::proof::word::Word;

/// Unit roundoff of a word, `2^-53`.
pub(crate) const U: f64 = 1.110_223_024_625_156_5e-16;

/// A number whose operations are rounded within bounds: `|fl(a op b) - (a op b)| <= BOUND |fl(a op b)|`, with [`UNDERFLOW`] more for a
/// product.
pub(crate) trait Number: Copy + core::fmt::Debug {
    /// What its parts and all bounds are.
    type Word: Word;

    /// Bound of a sum.
    const SUM: f64;
    /// Bound of a product.
    const PRODUCT: f64;
    /// Bound of the sum with a small number, over the larger one: that is less than twice the sum.
    const SMALL_SUM: f64 = 2.0 * Self::SUM;
    /// Bound of the sum of two words.
    const SUM_OF_WORDS: f64 = 0.0;

    /// The sum of four words, each at most an ulp of the one before: the first ones that the number has room for.
    fn of_parts(parts: [f64; 4]) -> Self;
    /// A word, exactly.
    fn of_word(word: Self::Word) -> Self;
    /// The product of two words, exactly; of one word it is rounded.
    fn of_product(a: Self::Word, b: Self::Word) -> Self;
    /// The sum.
    fn plus(self, other: Self) -> Self;
    /// The sum with a number of at most three quarters of its size: `|fl(a + b) - (a + b)| <= SMALL_SUM |a|`.
    #[inline(always)]
    fn plus_small(self, other: Self) -> Self {
        self.plus(other)
    }
    /// The product.
    fn times(self, other: Self) -> Self;
    /// The number of opposite sign, exactly.
    fn negated(self) -> Self;
    /// The product with a power of two, exactly.
    fn scaled(self, power: Self::Word) -> Self;
    /// The leading word: the number is within a relative 2u of it.
    fn leading(self) -> Self::Word;
    /// Nearly its inverse; nothing is promised.
    fn near_inverse(self) -> Self;
    /// Nearly its square root; nothing is promised.
    fn near_root(self) -> Self;
    /// The first number where the truth holds, else the second.
    fn select(truth: <Self::Word as Word>::Mask, first: Self, second: Self) -> Self;

    /// A number in all lanes.
    #[inline(always)]
    fn of(number: f64) -> Self {
        Self::of_word(Self::Word::of(number))
    }

    /// The difference.
    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        self.plus(other.negated())
    }

    /// The absolute value of the leading word.
    #[inline(always)]
    fn size(self) -> Self::Word {
        self.leading().size()
    }
}

/// What a product may be off by where its parts underflow, flushed to zero or not: far more than the few smallest normal numbers that its
/// roundings lose.
pub(crate) const UNDERFLOW: f64 = 1e-290;

/// Two words, `hi + lo` with `hi` the word nearest to the sum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoWords<W> {
    pub(crate) hi: W,
    pub(crate) lo: W,
}

/// The exact sum of two words (Knuth).
#[inline(always)]
pub(crate) fn two_sum<W: Word>(a: W, b: W) -> TwoWords<W> {
    let hi = a + b;
    let b_as_added = hi - a;
    TwoWords { hi, lo: (a - (hi - b_as_added)) + (b - b_as_added) }
}

/// The exact sum of two words with `|a| >= |b|` or `a = 0` (Dekker).
#[inline(always)]
fn ordered_sum<W: Word>(a: W, b: W) -> TwoWords<W> {
    let hi = a + b;
    TwoWords { hi, lo: b - (hi - a) }
}

impl<W: Word> Number for TwoWords<W> {
    type Word = W;
    /// `3u² + 13u³` of the exact sum (AccurateDWPlusDW, theorem 3.1 of Joldes, Muller, Popescu 2017), less than `4u²` of the rounded one.
    const SUM: f64 = 4.0 * U * U;
    /// The terms of order u² that are lost: `lo lo'` is rounded (u³), `lo hi'` (u²) and the sum of both (u²), `hi lo'` (u²), its sum with
    /// them (2u²), and its sum with the low part of `hi hi'` (3u², as large as all three terms): `8u² + O(u³)`, taken as `9u²`.
    const PRODUCT: f64 = 9.0 * U * U;
    /// With |b| <= 3|a|/4 the sum of the leading words is exact in two words. The low words are at most u of either, so their rounded sum is off by
    /// `1.8u²` of a. What the leading sum lacks is u of `1.8a`, so the sum of these parts is off by `3.6u²` of a. The last step is exact: its
    /// second word is below `4u` of a, its first one above a fifth of it.
    const SMALL_SUM: f64 = 6.0 * U * U;

    #[inline(always)]
    fn of_parts([hi, lo, ..]: [f64; 4]) -> Self {
        TwoWords { hi: W::of(hi), lo: W::of(lo) }
    }

    #[inline(always)]
    fn of_word(word: W) -> Self {
        TwoWords { hi: word, lo: W::of(0.0) }
    }

    #[inline(always)]
    fn of_product(a: W, b: W) -> Self {
        let hi = a * b;
        TwoWords { hi, lo: a.product_error(b, hi) }
    }

    #[inline(always)]
    fn plus(self, other: Self) -> Self {
        let upper = two_sum(self.hi, other.hi);
        let lower = two_sum(self.lo, other.lo);
        let sum = ordered_sum(upper.hi, upper.lo + lower.hi);
        ordered_sum(sum.hi, lower.lo + sum.lo)
    }

    #[inline(always)]
    fn plus_small(self, other: Self) -> Self {
        let upper = ordered_sum(self.hi, other.hi);
        ordered_sum(upper.hi, upper.lo + (self.lo + other.lo))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let product = Self::of_product(self.hi, other.hi);
        let cross = self.hi * other.lo + (self.lo * other.hi + self.lo * other.lo);
        ordered_sum(product.hi, product.lo + cross)
    }

    #[inline(always)]
    fn negated(self) -> Self {
        TwoWords { hi: -self.hi, lo: -self.lo }
    }

    #[inline(always)]
    fn scaled(self, power: W) -> Self {
        TwoWords { hi: self.hi * power, lo: self.lo * power }
    }

    #[inline(always)]
    fn leading(self) -> W {
        self.hi
    }

    #[inline(always)]
    fn near_inverse(self) -> Self {
        let first = W::of(1.0) / self.hi;
        let rest = Self::of(1.0).minus(self.times(Self::of_word(first)));
        ordered_sum(first, rest.hi * first)
    }

    #[inline(always)]
    fn near_root(self) -> Self {
        let root = self.hi.root();
        let rest = self.minus(Self::of_product(root, root));
        // of zero it is zero, not a NaN
        let doubled = (root + root).or_larger(W::of(f64::MIN_POSITIVE));
        ordered_sum(root, rest.hi / doubled)
    }

    #[inline(always)]
    fn select(truth: W::Mask, first: Self, second: Self) -> Self {
        TwoWords { hi: W::select(truth, first.hi, second.hi), lo: W::select(truth, first.lo, second.lo) }
    }
}

/// One word: tests see in it what rounding does, which two words hide.
#[cfg(test)]
#[derive(Clone, Copy, Debug)]
pub(crate) struct OneWord(pub(crate) f64);

#[cfg(test)]
impl Number for OneWord {
    type Word = f64;
    const SUM_OF_WORDS: f64 = Self::SUM;
    const SUM: f64 = U * (1.0 + 2.0 * U);
    const PRODUCT: f64 = U * (1.0 + 2.0 * U);

    fn of_parts([hi, ..]: [f64; 4]) -> Self {
        OneWord(hi)
    }

    fn of_word(word: f64) -> Self {
        OneWord(word)
    }

    fn of_product(a: f64, b: f64) -> Self {
        OneWord(a * b)
    }

    fn plus(self, other: Self) -> Self {
        OneWord(self.0 + other.0)
    }

    fn times(self, other: Self) -> Self {
        OneWord(self.0 * other.0)
    }

    fn negated(self) -> Self {
        OneWord(-self.0)
    }

    fn scaled(self, power: f64) -> Self {
        OneWord(self.0 * power)
    }

    fn leading(self) -> f64 {
        self.0
    }

    fn near_inverse(self) -> Self {
        OneWord(1.0 / self.0)
    }

    fn near_root(self) -> Self {
        OneWord(self.0.sqrt())
    }

    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }
}

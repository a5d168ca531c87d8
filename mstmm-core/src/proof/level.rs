//! Numbers as functions need them: enough terms and words of constants, and numbers of one lane for what does not depend on the frequency.

use crate::proof::number::{Number, TwoWords, U};
use crate::proof::word::{Word, load};

/// A number for which series have enough terms and constants enough words.
pub(crate) trait Level: Number {
    /// The number of one lane.
    type Alone: Level<Word = f64, Alone = Self::Alone>;
    /// Relative bound of [`Number::of_product`].
    const PRODUCT_OF_WORDS: f64 = 0.0;
    /// Number of parts of π/2 and ln 2, and what they leave of either.
    const PARTS: (usize, f64);
    /// Number of terms of a series in `y^k/(2k)!` with |y| <= 1: the next one is below the rounding of the first.
    const TERMS: usize;
    /// The size of a term beside the first one from which on words do for a series: their rounding is below that of the number then.
    const IN_WORDS: f64 = 0.0;

    /// A number in all lanes.
    fn everywhere(alone: Self::Alone) -> Self;
    /// A number in each lane; that of the first one, where there are no others.
    #[inline(always)]
    fn of_lanes<A>(lanes: &[A], of: &dyn Fn(&A) -> Self::Alone) -> Self {
        Self::everywhere(of(&lanes[0]))
    }
    /// The number of a lane.
    fn lane(self, lane: usize) -> Self::Alone;
}

impl<W: Word> Level for TwoWords<W> {
    type Alone = TwoWords<f64>;
    const PARTS: (usize, f64) = (4, 3e-66);
    const TERMS: usize = 14;
    const IN_WORDS: f64 = 0.5 * U;

    #[inline(always)]
    fn everywhere(alone: TwoWords<f64>) -> Self {
        TwoWords { hi: W::of(alone.hi), lo: W::of(alone.lo) }
    }

    #[inline(always)]
    fn of_lanes<A>(lanes: &[A], of: &dyn Fn(&A) -> TwoWords<f64>) -> Self {
        TwoWords { hi: load(lanes, &|lane| of(lane).hi), lo: load(lanes, &|lane| of(lane).lo) }
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> TwoWords<f64> {
        TwoWords { hi: self.hi.lane(lane), lo: self.lo.lane(lane) }
    }
}

#[cfg(test)]
impl Level for crate::proof::number::OneWord {
    type Alone = Self;
    const PRODUCT_OF_WORDS: f64 = crate::proof::number::U * (1.0 + 1e-10);
    const PARTS: (usize, f64) = (4, 3e-66);
    const TERMS: usize = 9;

    fn everywhere(alone: Self) -> Self {
        alone
    }

    fn lane(self, _: usize) -> Self {
        self
    }
}

//! Four words: the last resort, slow and simple. A sum keeps all of its terms, and a product all of its parts, until they are distilled; what is
//! dropped then is looked at.

use crate::proof::level::Level;
use crate::proof::number::{Number, two_sum};
use crate::proof::word::Word;

/// The sum of four words by falling size, each at most half an ulp of the one before.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FourWords([f64; 4]);

/// Number of words that are kept.
const KEPT: usize = 4;

/// Number of terms of a product: 16 products of words, and what each lacks.
const TERMS_OF_PRODUCT: usize = 2 * KEPT * KEPT;

impl FourWords {
    /// The words, of which the number is the sum.
    #[cfg(test)]
    pub(crate) fn words(self) -> [f64; 4] {
        self.0
    }

    /// Nothing is known of it.
    fn unknown() -> Self {
        FourWords([f64::NAN, 0.0, 0.0, 0.0])
    }

    /// The first four words of a sum, without a change of its value until the rest is dropped.
    ///
    /// Each pass replaces neighbours by their rounded sum and its error. A pass that changes nothing has found words of which each is at most
    /// half an ulp of the one before. Then the rest is below `u^4 = 1.6e-64` of the first word; it is compared with the bound all the same.
    fn distilled<const TERMS: usize>(mut terms: [f64; TERMS], bound: f64) -> Self {
        // a pass moves each word to its place but one at worst; NaN and infinity never come to rest
        for _ in 0..=TERMS {
            let mut is_at_rest = true;
            for i in (1..TERMS).rev() {
                let sum = two_sum(terms[i - 1], terms[i]);
                is_at_rest &= sum.hi == terms[i - 1] && sum.lo == terms[i];
                (terms[i - 1], terms[i]) = (sum.hi, sum.lo);
            }
            if is_at_rest {
                let mut words = [0.0; KEPT];
                words.copy_from_slice(&terms[..KEPT]);
                let rest: f64 = terms[KEPT..].iter().map(|term| term.size()).sum();
                // 0.99: the sum of the rest is rounded, and so is the bound
                return if rest <= 0.99 * bound * words[0].size() { FourWords(words) } else { Self::unknown() };
            }
        }
        Self::unknown()
    }

    /// The distilled sum.
    #[inline(never)]
    fn sum([a, b, c, d]: [f64; 4], [e, f, g, h]: [f64; 4]) -> Self {
        Self::distilled([a, e, b, f, c, g, d, h], Self::SUM)
    }

    /// The distilled product: terms by falling size, first the products of words i and j with i + j = n, then what those of `n - 1` lack.
    #[inline(never)]
    fn product(a: [f64; 4], b: [f64; 4]) -> Self {
        let mut terms = [0.0; TERMS_OF_PRODUCT];
        let mut at = 0;
        for order in 0..2 * KEPT {
            for (i, &first) in a.iter().enumerate() {
                for (j, &second) in b.iter().enumerate() {
                    let product = first * second;
                    if i + j == order {
                        terms[at] = product;
                    } else if i + j + 1 == order {
                        terms[at] = first.product_error(second, product);
                    } else {
                        continue;
                    }
                    at += 1;
                }
            }
        }
        Self::distilled(terms, Self::PRODUCT)
    }
}

impl Number for FourWords {
    type Word = f64;
    /// What [`FourWords::distilled`] drops is compared with it: far above the `1.6e-64` that is dropped, far below the rounding of two words.
    const SUM: f64 = 1e-60;
    /// As that of a sum: the products and what they lack are exact, unless they underflow.
    const PRODUCT: f64 = 1e-60;

    fn of_parts(parts: [f64; 4]) -> Self {
        FourWords(parts)
    }

    fn of_word(word: f64) -> Self {
        FourWords([word, 0.0, 0.0, 0.0])
    }

    fn of_product(a: f64, b: f64) -> Self {
        let product = a * b;
        FourWords([product, a.product_error(b, product), 0.0, 0.0])
    }

    fn plus(self, other: Self) -> Self {
        Self::sum(self.0, other.0)
    }

    fn times(self, other: Self) -> Self {
        Self::product(self.0, other.0)
    }

    fn negated(self) -> Self {
        FourWords(self.0.map(|word| -word))
    }

    fn scaled(self, power: f64) -> Self {
        FourWords(self.0.map(|word| word * power))
    }

    fn leading(self) -> f64 {
        self.0[0]
    }

    /// Two steps of Newton's: from 16 digits to 32, to 64.
    fn near_inverse(self) -> Self {
        let mut inverse = Self::of(1.0 / self.0[0]);
        for _ in 0..2 {
            let residual = Self::of(1.0).minus(self.times(inverse));
            inverse = inverse.plus(inverse.times(residual));
        }
        inverse
    }

    /// Steps of Newton's with the slope of the first one: each has some 15 digits more.
    fn near_root(self) -> Self {
        let first = self.0[0].root();
        let mut root = Self::of(first);
        // of zero it is zero, not a NaN
        if first == 0.0 {
            return root;
        }
        let half_inverse = Self::of(0.5 / first);
        for _ in 0..4 {
            let residual = self.minus(root.times(root));
            root = root.plus(half_inverse.times(residual));
        }
        root
    }

    fn select(truth: bool, first: Self, second: Self) -> Self {
        if truth { first } else { second }
    }
}

impl Level for FourWords {
    type Alone = Self;
    const PARTS: (usize, f64) = (7, 1e-114);
    const TERMS: usize = 24;

    fn everywhere(alone: Self) -> Self {
        alone
    }

    fn lane(self, _: usize) -> Self {
        self
    }
}

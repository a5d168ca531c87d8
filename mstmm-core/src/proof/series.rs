//! Taylor series in inverse factorials with fixed bounds: all that rounding may do is added up when the program is compiled.

use crate::number::constants::RECIPROCAL_FACTORIALS;
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::{U, UNDERFLOW};
use crate::proof::word::Word;

/// How series `Σ_k c_k y^k` with `c_k = 1/(stride k + first)!` and `|y| <= Y` are summed, by Horner's rule.
#[derive(Clone, Copy)]
struct Plan {
    /// Number of terms.
    terms: usize,
    /// The first term that is added up in words.
    in_words: usize,
}

/// Bounds of a series, whatever y is.
#[derive(Clone, Copy)]
struct Bounds {
    /// Of the rounded sum less the whole series.
    error: f64,
    /// Of the slope of the whole series.
    slope: f64,
}

/// Bounds are sums and products of positive numbers, each off by u of itself at most; there are less than a thousand of them.
const ADDED_UP: f64 = 1.0 + 1e-12;

/// What the rest may be of the rounding of the first term.
const OF_REST: f64 = 0.02;

/// `c_k`.
const fn coefficient([first, stride]: [usize; 2], k: usize) -> f64 {
    RECIPROCAL_FACTORIALS[stride * k + first][0]
}

impl Plan {
    /// The plan whose rest, and whose terms in words, are below the rounding of a number beside the first term. So they are for a larger `first`.
    const fn of<N: Level>(series: [usize; 2], most: f64) -> Self {
        let first = coefficient(series, 0);
        let (mut terms, mut in_words, mut power) = (0, 0, 1.0);
        while 2.0 * coefficient(series, terms) * power > OF_REST * N::SUM * first {
            if coefficient(series, terms) * power > N::IN_WORDS * first {
                in_words = terms + 1;
            }
            (terms, power) = (terms + 1, power * most);
        }
        Plan { terms, in_words }
    }

    /// The bounds.
    ///
    /// Let m bound the stored sum w, and e its error. The next sum is `w y + c`. Its error is `e Y` and the roundings: that of the product, of
    /// `m Y`; of the constant, of c; of the sum, of c, since `m Y <= 3c/4`. In words the product lacks u, the leading word of y 2u, the constant
    /// u, and the sum u of `m Y + c`. From one term to the next the rest falls by more than a half: it is twice the first term that is left out.
    const fn bounds<N: Level>(self, series: [usize; 2], most: f64) -> Bounds {
        let Plan { terms, in_words } = self;
        let mut k = terms - 1;
        let mut stored = coefficient(series, k) * (1.0 + 2.0 * U);
        let mut error = coefficient(series, k) * if in_words < terms { 1.01 * U } else { N::SUM };
        while k > 0 {
            k -= 1;
            let (product, c) = (stored * most, coefficient(series, k));
            assert!(product <= 0.75 * c);
            let rounded = if k < in_words {
                1.01 * (N::PRODUCT * product + (N::SUM + N::SMALL_SUM) * c)
            } else {
                1.01 * U * (4.0 * product + 2.0 * c)
            };
            error = error * most + rounded + 2.0 * UNDERFLOW;
            stored = (product + c) * (1.0 + 4.0 * U);
        }
        let (mut slope, mut power, mut k) = (0.0, 1.0, 1);
        while k < terms {
            slope += k as f64 * coefficient(series, k) * power;
            (power, k) = (power * most, k + 1);
        }
        // the slopes of the rest fall by a quarter at least
        let last = coefficient(series, terms) * power;
        assert!(terms > 1 && coefficient(series, terms + 1) * most <= 0.5 * coefficient(series, terms));
        Bounds { error: (error + 2.0 * last * most) * ADDED_UP, slope: (slope + 4.0 * terms as f64 * last) * ADDED_UP }
    }
}

/// The plan of several series, and the bounds of each.
const fn planned<N: Level, const K: usize>(first: usize, stride: usize, most: f64) -> (Plan, [Bounds; K]) {
    let plan = Plan::of::<N>([first, stride], most);
    let mut bounds = [Bounds { error: 0.0, slope: 0.0 }; K];
    let mut k = 0;
    while k < K {
        bounds[k] = plan.bounds::<N>([first + k, stride], most);
        k += 1;
    }
    (plan, bounds)
}

impl<N: Level> Ball<N> {
    /// `Σ_k y^k / (STRIDE k + first)!` for K numbers `first`, from FIRST on, where no number of the ball is larger in size than SIXTEENTHS/16.
    /// Elsewhere it says nothing. The sums are found side by side: each operation waits for the one before.
    #[inline(always)]
    pub(crate) fn series<const FIRST: usize, const K: usize, const STRIDE: usize, const SIXTEENTHS: usize>(
        self,
    ) -> [Self; K] {
        let (plan, bounds) = const { planned::<N, K>(FIRST, STRIDE, SIXTEENTHS as f64 / 16.0) };
        let c = |k: usize, series: usize| RECIPROCAL_FACTORIALS[STRIDE * k + FIRST + series];
        let last = plan.terms - 1;
        let mut sums = [N::of(0.0); K];
        let mut next = plan.in_words;
        if next > last {
            next = last;
            for (series, sum) in sums.iter_mut().enumerate() {
                *sum = N::of_parts(c(last, series));
            }
        } else {
            let y = self.mid.leading();
            let mut words = [N::Word::of(0.0); K];
            for (series, word) in words.iter_mut().enumerate() {
                *word = N::Word::of(c(last, series)[0]);
            }
            for k in (next..last).rev() {
                for (series, word) in words.iter_mut().enumerate() {
                    *word = *word * y + N::Word::of(c(k, series)[0]);
                }
            }
            for (sum, word) in sums.iter_mut().zip(words) {
                *sum = N::of_word(word);
            }
        }
        for k in (0..next).rev() {
            for (series, sum) in sums.iter_mut().enumerate() {
                *sum = N::of_parts(c(k, series)).plus_small(sum.times(self.mid));
            }
        }
        let mut balls = [Ball::of(0.0); K];
        for (series, ball) in balls.iter_mut().enumerate() {
            let Bounds { error, slope } = bounds[series];
            *ball = Ball::exactly(sums[series]).widened(self.rad * N::Word::of(slope) + N::Word::of(error));
        }
        balls
    }
}

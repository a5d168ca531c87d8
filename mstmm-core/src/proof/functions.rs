//! Elementary functions of balls: the argument is reduced by exact products, and [series](crate::proof::series) of the rest are put together
//! in balls. No function needs a proof of its own rounding.

use crate::number::constants::{HALF_PI, LN_2, RECIPROCAL_FACTORIALS};
use crate::proof::ball::Ball;
use crate::proof::level::Level;
use crate::proof::number::UNDERFLOW;
use crate::proof::word::{Word, apart};

/// Most quarter turns by which an angle is reduced, `2^40`: their products with parts of π/2 are exact in two words, and a leading word tells
/// a whole number of them from the next one.
const MOST_TURNS: f64 = 1_099_511_627_776.0;

/// An exponent beyond which `e^-x` is a ball about zero.
const MOST_DECAY: f64 = 650.0;

/// A bound of `e^-x` beyond [`MOST_DECAY`], which is 5e-283.
const LEAST_DECAY: f64 = 1e-282;

impl<N: Level> Ball<N> {
    /// The product of two words.
    #[inline(always)]
    pub(crate) fn of_product(a: N::Word, b: N::Word) -> Self {
        let mid = N::of_product(a, b);
        Ball { mid, rad: mid.size() * N::Word::of(N::PRODUCT_OF_WORDS) + N::Word::of(UNDERFLOW) }
    }

    /// `1/n!`: the words that are left out are below the rounding of a sum.
    #[inline(always)]
    pub(crate) fn reciprocal_factorial(n: usize) -> Self {
        let parts = RECIPROCAL_FACTORIALS[n];
        Ball { mid: N::of_parts(parts), rad: N::Word::of(parts[0] * N::SUM) }
    }

    /// The ball less a whole number times a constant in parts.
    #[inline(always)]
    fn reduced(self, whole: N::Word, parts: &[f64; 7]) -> Self {
        let (count, rest) = N::PARTS;
        let mut reduced = self;
        for part in &parts[..count] {
            reduced = reduced + Self::of_product(-whole, N::Word::of(*part));
        }
        reduced.widened(whole.size() * N::Word::of(rest))
    }

    /// Sine and cosine. Beyond [`MOST_TURNS`] quarter turns both are known to be in [-1, 1] alone.
    #[inline(always)]
    pub(crate) fn sin_cos(self) -> [Self; 2] {
        sin_cos(self)
    }

    /// `e^-x` for x >= 0.
    #[inline(always)]
    pub(crate) fn decay(self) -> Self {
        decay(self)
    }
}

apart! {
    /// See [`Ball::sin_cos`].
    fn sin_cos<N: Level>(x: Ball<N>) -> [Ball<N>; 2] {
        let word = N::Word::of;
        let turns = (x.mid.leading() * word(core::f64::consts::FRAC_2_PI)).nearest();
        let is_known = turns.size().is_less(word(MOST_TURNS));
        let turns = N::Word::select(is_known, turns, word(0.0));
        let angle = x.reduced(turns, &HALF_PI);
        // |angle| <= π/4 (1 + 1e-9), unless its ball is wide
        let square = angle * angle;
        let y = -square;
        let [c, s] = y.series::<2, 2, 2, 10>();
        let (sine, cosine) = (angle + angle * (y * s), Ball::<N>::of(1.0) + y * c);
        let is_small = square.largest().is_less(word(0.625));
        let is_odd = turns.is_odd();
        // the second bit: that of the even number below
        let half = (turns - N::Word::select(is_odd, word(1.0), word(0.0))) * word(0.5);
        let is_turned = half.is_odd();
        let [sin, cos] = [Ball::select(is_odd, cosine, sine), Ball::select(is_odd, -sine, cosine)];
        let [sin, cos] = [Ball::select(is_turned, -sin, sin), Ball::select(is_turned, -cos, cos)];
        let anywhere = Ball { mid: N::of(0.0), rad: word(1.0) };
        let is_known = N::Word::both(is_known, is_small);
        [Ball::select(is_known, sin, anywhere), Ball::select(is_known, cos, anywhere)]
    }

    /// See [`Ball::decay`].
    fn decay<N: Level>(x: Ball<N>) -> Ball<N> {
        let word = N::Word::of;
        let is_moderate = x.mid.leading().is_less(word(MOST_DECAY));
        let halvings = (x.mid.leading() * word(core::f64::consts::LOG2_E)).nearest();
        let halvings = N::Word::select(is_moderate, halvings, word(0.0));
        let rest = -x.reduced(halvings, &LN_2);
        // |rest| <= ln 2 / 2 (1 + 1e-9), unless the ball is wide; hyperbolic cosine and sine of it
        let square = rest * rest;
        let [c, s] = square.series::<2, 2, 2, 2>();
        let exponential = Ball::<N>::of(1.0) + (rest + (square * c + rest * (square * s)));
        let is_small = square.largest().is_less(word(0.125));
        let power = (-halvings).power_of_two();
        let decay = Ball { mid: exponential.mid.scaled(power), rad: exponential.rad * power + word(UNDERFLOW) };
        let unknown = Ball { mid: N::of(0.0), rad: word(f64::INFINITY) };
        let known = Ball::<N>::select(is_small, decay, unknown);
        let is_large = word(MOST_DECAY * (1.0 - 1e-9)).is_less(x.mid.leading() - x.rad);
        let large = Ball::<N>::select(is_large, Ball { mid: N::of(0.0), rad: word(LEAST_DECAY) }, unknown);
        Ball::<N>::select(is_moderate, known, large)
    }
}

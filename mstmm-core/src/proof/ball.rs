//! Balls: a number and a bound of its distance from the exact one, for each operation without a proof of its own.

use crate::proof::level::Level;
use crate::proof::number::{Number, UNDERFLOW};
use crate::proof::word::{Word, load};
use core::ops::{Add, Mul, Neg, Sub};

/// A number within `rad` of `mid`. A bound that is infinite or NaN says nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ball<N: Number> {
    pub(crate) mid: N,
    pub(crate) rad: N::Word,
}

/// A bound is the rounded sum and product of some ten positive numbers, and takes leading words for numbers: each is a relative 2u at most.
pub(crate) const ROUNDED: f64 = 1.0 + 1e-14;

/// It multiplies the leading word of a number, which is above the number by a relative 2u at most: the product is below the number.
pub(crate) const LOWERED: f64 = 1.0 - 1e-14;

impl<N: Number> Ball<N> {
    /// A number, exactly.
    #[inline(always)]
    pub(crate) fn exactly(mid: N) -> Self {
        Ball { mid, rad: N::Word::of(0.0) }
    }

    /// A word in all lanes, exactly.
    #[inline(always)]
    pub(crate) fn of(number: f64) -> Self {
        Self::exactly(N::of(number))
    }

    /// The sum of two words in all lanes: exactly, if a number has room for both.
    #[inline(always)]
    pub(crate) fn of_pair([hi, lo]: [f64; 2]) -> Self {
        let mid = N::of(hi).plus(N::of(lo));
        Ball { mid, rad: mid.size() * N::Word::of(N::SUM_OF_WORDS) }
    }

    /// The ball with a larger bound.
    #[inline(always)]
    pub(crate) fn widened(self, by: N::Word) -> Self {
        Ball { mid: self.mid, rad: (self.rad + by) * N::Word::of(ROUNDED) }
    }

    /// The product with a power of two.
    #[inline(always)]
    pub(crate) fn scaled(self, power: f64) -> Self {
        let power = N::Word::of(power);
        Ball { mid: self.mid.scaled(power), rad: self.rad * power.size() }
    }

    /// No number of the ball is larger than this.
    #[inline(always)]
    pub(crate) fn largest(self) -> N::Word {
        (self.mid.size() + self.rad) * N::Word::of(ROUNDED)
    }

    /// No number of the ball is smaller in size than this, which is negative where zero is in the ball.
    #[inline(always)]
    pub(crate) fn least(self) -> N::Word {
        self.mid.size() * N::Word::of(LOWERED) - self.rad
    }

    /// Its inverse `m`, whatever it is: `|1/b - m| = |1 - b m| / |b|` for each b of the ball.
    #[inline(always)]
    pub(crate) fn inverse(self) -> Self {
        let mid = self.mid.near_inverse();
        let residual = Self::of(1.0) - self * Self::exactly(mid);
        let (zero, least) = (N::Word::of(0.0), self.least());
        let rad = residual.largest() / least * N::Word::of(ROUNDED);
        Ball { mid, rad: N::Word::select(zero.is_less(least), rad, N::Word::of(f64::INFINITY)) }
    }

    /// The square root `r` of a ball of positive numbers, whatever it is: `|√x - r| = |x - r²| / (√x + r)`.
    #[inline(always)]
    pub(crate) fn root(self) -> Self {
        let mid = self.mid.near_root();
        let residual = self - Self::exactly(mid) * Self::exactly(mid);
        // a negative number is no root, and zero is a quotient without a bound
        let rad = residual.largest() / (mid.leading() * N::Word::of(LOWERED)) * N::Word::of(ROUNDED);
        let infinite = N::Word::of(f64::INFINITY);
        let rad = N::Word::select(N::Word::of(0.0).is_less(mid.leading()), rad, infinite);
        Ball { mid, rad: N::Word::select(self.is_positive(), rad, infinite) }
    }

    /// Whether all numbers of the ball are positive, in each lane.
    #[inline(always)]
    pub(crate) fn is_positive(self) -> <N::Word as Word>::Mask {
        N::Word::of(0.0).is_less(self.mid.leading() * N::Word::of(LOWERED) - self.rad)
    }

    /// Whether all numbers of the ball are negative, in each lane.
    #[inline(always)]
    pub(crate) fn is_negative(self) -> <N::Word as Word>::Mask {
        (-self).is_positive()
    }

    /// The first ball where the truth holds, else the second.
    #[inline(always)]
    pub(crate) fn select(truth: <N::Word as Word>::Mask, first: Self, second: Self) -> Self {
        Ball { mid: N::select(truth, first.mid, second.mid), rad: N::Word::select(truth, first.rad, second.rad) }
    }
}

impl<N: Level> Ball<N> {
    /// A ball in all lanes.
    #[inline(always)]
    pub(crate) fn everywhere(alone: Ball<N::Alone>) -> Self {
        Ball { mid: N::everywhere(alone.mid), rad: N::Word::of(alone.rad) }
    }

    /// A ball in each lane.
    #[inline(always)]
    pub(crate) fn of_lanes<A>(lanes: &[A], of: &dyn Fn(&A) -> Ball<N::Alone>) -> Self {
        Ball { mid: N::of_lanes(lanes, &|lane| of(lane).mid), rad: load(lanes, &|lane| of(lane).rad) }
    }

    /// The ball of a lane.
    #[inline(always)]
    pub(crate) fn lane(self, lane: usize) -> Ball<N::Alone> {
        Ball { mid: self.mid.lane(lane), rad: self.rad.lane(lane) }
    }
}

impl<N: Number> Add for Ball<N> {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let mid = self.mid.plus(other.mid);
        Ball { mid, rad: (self.rad + other.rad + N::Word::of(N::SUM) * mid.size()) * N::Word::of(ROUNDED) }
    }
}

impl<N: Number> Sub for Ball<N> {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<N: Number> Mul for Ball<N> {
    type Output = Self;

    /// `|a b - mid mid'| <= |mid| rad' + (|mid'| + rad') rad`.
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let mid = self.mid.times(other.mid);
        let spread = self.mid.size() * other.rad + (other.mid.size() + other.rad) * self.rad;
        let rounded = N::Word::of(N::PRODUCT) * mid.size();
        Ball { mid, rad: (spread + rounded) * N::Word::of(ROUNDED) + N::Word::of(UNDERFLOW) }
    }
}

impl<N: Number> Neg for Ball<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Ball { mid: self.mid.negated(), rad: self.rad }
    }
}

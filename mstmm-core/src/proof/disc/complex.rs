//! Complex numbers with a bound of their distance from the exact ones: discs.

use crate::number::Scalar;
use crate::number::constants::RECIPROCAL_FACTORIALS;
use crate::proof::ball::{Ball, LOWERED, ROUNDED};
use crate::proof::level::Level;
use crate::proof::number::UNDERFLOW;
use core::ops::{Add, Mul, Neg, Sub};
use num_complex::Complex;

/// A number within `rad` of `re + i im`. A bound that is infinite or NaN says nothing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ComplexBall<N> {
    pub(crate) re: N,
    pub(crate) im: N,
    pub(crate) rad: f64,
}

/// It multiplies δ: `e^δ - 1` is convex, so it is below `(e - 1) δ` for δ up to 1. This is `e - 1`, rounded up.
const GROWTH: f64 = 1.7183;

/// The size of a complex number, rounded by a few u.
pub(crate) fn modulus(re: f64, im: f64) -> f64 {
    let (re, im) = (re.abs(), im.abs());
    let (large, small) = if re >= im { (re, im) } else { (im, re) };
    if large == 0.0 {
        return small;
    }
    let ratio = small / large;
    large * Scalar::sqrt(1.0 + ratio * ratio)
}

/// The larger of two numbers, and a NaN where one is.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

impl<N: Level<Word = f64>> ComplexBall<N> {
    /// A number, exactly.
    pub(crate) fn exactly(re: N, im: N) -> Self {
        ComplexBall { re, im, rad: 0.0 }
    }

    /// A word, exactly.
    pub(crate) fn of(number: f64) -> Self {
        Self::exactly(N::of(number), N::of(0.0))
    }

    /// The numbers whose parts are in two balls.
    pub(crate) fn of_parts(re: Ball<N>, im: Ball<N>) -> Self {
        ComplexBall { re: re.mid, im: im.mid, rad: (re.rad + im.rad) * ROUNDED }
    }

    /// Real numbers.
    pub(crate) fn real(ball: Ball<N>) -> Self {
        ComplexBall { re: ball.mid, im: N::of(0.0), rad: ball.rad }
    }

    /// The size of the centre, rounded.
    pub(crate) fn size(self) -> f64 {
        modulus(self.re.leading(), self.im.leading())
    }

    /// No number of the ball is larger than this.
    pub(crate) fn largest(self) -> f64 {
        (self.size() + self.rad) * ROUNDED
    }

    /// No number of the ball is smaller in size than this, which is negative where zero is in the ball.
    pub(crate) fn least(self) -> f64 {
        self.size() * LOWERED - self.rad
    }

    /// The ball with a larger bound.
    pub(crate) fn widened(self, by: f64) -> Self {
        ComplexBall { rad: (self.rad + by) * ROUNDED, ..self }
    }

    /// The product with a power of two.
    pub(crate) fn scaled(self, power: f64) -> Self {
        ComplexBall { re: self.re.scaled(power), im: self.im.scaled(power), rad: self.rad * power.abs() + UNDERFLOW }
    }

    /// The product with i.
    pub(crate) fn times_i(self) -> Self {
        ComplexBall { re: self.im.negated(), im: self.re, rad: self.rad }
    }

    /// The centre in words.
    pub(crate) fn leading(self) -> Complex<f64> {
        Complex::new(self.re.leading(), self.im.leading())
    }

    /// Nearly the inverse of the centre; nothing is promised.
    fn near_inverse(self) -> Self {
        let inverse = self.re.times(self.re).plus(self.im.times(self.im)).near_inverse();
        Self::exactly(self.re.times(inverse), self.im.times(inverse).negated())
    }

    /// Its inverse `m`, whatever it is: `|1/b - m| = |1 - b m| / |b|` for each b of the ball.
    pub(crate) fn inverse(self) -> Self {
        let middle = self.near_inverse();
        let residual = Self::of(1.0) - self * middle;
        let least = self.least();
        let rad = if least > 0.0 { residual.largest() / least * ROUNDED } else { f64::INFINITY };
        ComplexBall { rad, ..middle }
    }

    /// A square root that is analytic on the ball.
    ///
    /// Let m be nearly that of the centre. Where `|b - m²| < |m²|`, `√(b/m²)` has a positive real part, so that `|√b + m| >= |m|`. Then
    /// `|√b - m| = |b - m²|/|√b + m|` is at most `|b - m²|/|m|`.
    pub(crate) fn root(self) -> Self {
        let mut middle = self.near_root();
        for _ in 0..2 {
            let better = (middle + self.centre() * middle.near_inverse()).scaled(0.5);
            middle = Self::exactly(better.re, better.im);
        }
        let residual = (self - middle * middle).largest();
        let least = middle.least();
        let is_known = residual < least * least * LOWERED;
        ComplexBall { rad: if is_known { residual / least * ROUNDED } else { f64::INFINITY }, ..middle }
    }

    /// The centre alone.
    fn centre(self) -> Self {
        ComplexBall { rad: 0.0, ..self }
    }

    /// The principal square root of the centre in words.
    fn near_root(self) -> Self {
        let Complex { re, im } = self.leading();
        let large = Scalar::sqrt(0.5 * (self.size() + re.abs()));
        let small = if large == 0.0 { 0.0 } else { 0.5 * im.abs() / large };
        let (real, imaginary) = if re >= 0.0 { (large, small) } else { (small, large) };
        Self::exactly(N::of(real), N::of(if im < 0.0 { -imaginary } else { imaginary }))
    }

    /// `e^-b`. Of each number δ off the centre m it is off by `|e^-m| (e^|δ| - 1)` at most.
    pub(crate) fn decay(self) -> Self {
        let [re, im] = [self.re, self.im].map(Ball::exactly);
        let size = if self.re.leading() < 0.0 { (-re).decay().inverse() } else { re.decay() };
        let [sine, cosine] = im.sin_cos();
        let middle = Self::of_parts(size * cosine, -(size * sine));
        let growth = if self.rad <= 1.0 { GROWTH * self.rad } else { f64::INFINITY };
        if self.rad == 0.0 { middle } else { middle.widened(middle.largest() * growth * ROUNDED) }
    }

    /// `1/n!`.
    fn reciprocal_factorial(n: usize) -> Self {
        Self::real(Ball::reciprocal_factorial(n))
    }

    /// `Σ_k y^k / (STRIDE k + FIRST)!` where no number of the ball is larger than 4. From one term to the next the rest falls by more than a half.
    pub(crate) fn series<const FIRST: usize, const STRIDE: usize>(self) -> Self {
        let terms = 2 * (N::TERMS + 3) / STRIDE + 1;
        let mut sum = Self::reciprocal_factorial(STRIDE * (terms - 1) + FIRST);
        let most = self.largest();
        let mut power = most;
        for k in (0..terms - 1).rev() {
            sum = sum * self + Self::reciprocal_factorial(STRIDE * k + FIRST);
            power *= most;
        }
        let rest = 2.0 * power * RECIPROCAL_FACTORIALS[STRIDE * terms + FIRST][0] * (1.0 + 1e-12) + UNDERFLOW;
        sum.widened(if most <= 4.0 { rest } else { f64::INFINITY })
    }
}

impl<N: Level<Word = f64>> Add for ComplexBall<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (re, im) = (self.re.plus(other.re), self.im.plus(other.im));
        let rounded = N::SUM * (re.size() + im.size());
        ComplexBall { re, im, rad: (self.rad + other.rad + rounded) * ROUNDED }
    }
}

impl<N: Level<Word = f64>> Sub for ComplexBall<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<N: Level<Word = f64>> Mul for ComplexBall<N> {
    type Output = Self;

    /// `|a b - m m'| <= |m| rad' + (|m'| + rad') rad`.
    fn mul(self, other: Self) -> Self {
        let pairs = [(self.re, other.re), (self.im, other.im), (self.re, other.im), (self.im, other.re)];
        let products = pairs.map(|(a, b)| a.times(b));
        let [first, second, third, fourth] = products;
        let (re, im) = (first.minus(second), third.plus(fourth));
        let spread = if self.rad == 0.0 && other.rad == 0.0 {
            0.0
        } else {
            self.size() * other.rad + (other.size() + other.rad) * self.rad
        };
        let sizes = products.iter().map(|product| product.size()).sum::<f64>();
        let rounded = N::PRODUCT * sizes + N::SUM * (re.size() + im.size());
        ComplexBall { re, im, rad: (spread + rounded) * ROUNDED + 4.0 * UNDERFLOW }
    }
}

impl<N: Level<Word = f64>> Mul<Ball<N>> for ComplexBall<N> {
    type Output = Self;

    fn mul(self, other: Ball<N>) -> Self {
        self * Self::real(other)
    }
}

impl<N: Level<Word = f64>> Neg for ComplexBall<N> {
    type Output = Self;

    fn neg(self) -> Self {
        ComplexBall { re: self.re.negated(), im: self.im.negated(), rad: self.rad }
    }
}

//! The functions of the two squared wave numbers of which a general beam's stiffness is made, in three forms: no divisor is small.

use crate::number::constants::RECIPROCAL_FACTORIALS;
use crate::proof::ball::Ball;
use crate::proof::general_bending::equations::{Equations, Roots, WavePair, either, select_all};
use crate::proof::level::Level;
use crate::proof::member::any;
use crate::proof::word::{Word, apart};
use core::ops::{Add, Mul, Sub};

/// With `C = cosh √κ` and `S = sinh √κ/√κ`: `W = (κ₁ S₁ C₂ - κ₂ C₁ S₂)/(κ₁ - κ₂)`, `R = S₁ S₂`, `V = (C₁ S₂ - S₁ C₂)/(2(κ₁ - κ₂))`,
/// `E = (1 - C₁ C₂ + s R/2)/δ`, `D = R/2 - (g + τh) E`, `c₁ = (κ₁ S₂ - κ₂ S₁)/(κ₁ - κ₂)`, `c₂ = (C₁ - C₂)/(κ₁ - κ₂)` and
/// `c₃ = (S₁ - S₂)/(κ₁ - κ₂)`. Last is about the size of the terms of `τR + 2σ²E`. All are times the same positive number.
pub(crate) type Products<N> = [Ball<N>; 9];

/// C and S, both times `e^-x`; x, which is √κ where that is real and not small, else 0; `e^-x`; the amplitudes of C and S.
type Waves<N> = [Ball<N>; 6];

/// Numbers with a bound of their error of which series are made: real or complex.
pub(crate) trait Summed: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A word, exactly.
    fn of(number: f64) -> Self;

    /// Twice the number.
    fn doubled(self) -> Self;

    /// The number over `n!`.
    fn over_factorial(self, n: usize) -> Self;
}

impl<N: Level> Summed for Ball<N> {
    #[inline(always)]
    fn of(number: f64) -> Self {
        Ball::of(number)
    }

    #[inline(always)]
    fn doubled(self) -> Self {
        self.scaled(2.0)
    }

    #[inline(always)]
    fn over_factorial(self, n: usize) -> Self {
        self * Ball::reciprocal_factorial(n)
    }
}

/// The factorials over which the series of [`short_sums`] begin; from one term to the next they grow by two.
pub(crate) const FIRSTS: [usize; 7] = [1, 2, 3, 4, 2, 3, 5];

/// The series of W, R/2, V, E, c₂, c₃ and `(1 - c₁)/d` in s, d and δ, with a number of terms. [`Equations::short`] derives them.
#[inline(always)]
pub(crate) fn short_sums<X: Summed>([s, d, square]: [X; 3], terms: usize) -> [X; 7] {
    let (zero, one) = (X::of(0.0), X::of(1.0));
    let (mut last, mut before) = ([one; 2], [zero; 2]);
    let mut sums = [zero; 7];
    for k in 0..terms {
        let [big, small] = last;
        let powers = [big - s * before[0], big, big, big, small, small, small];
        for (sum, (power, first)) in sums.iter_mut().zip(powers.into_iter().zip(FIRSTS)) {
            *sum = *sum + power.over_factorial(2 * k + first);
        }
        let next = [s.doubled() * big - square * before[0], s * small - d * before[1]];
        (before, last) = (last, next);
    }
    sums
}

apart! {
    /// Series, where `|s| <= 2` and `|d| <= 1`.
    ///
    /// With `u = s + 2√d` and `v = s - 2√d`, `H_k` is the sum of all products of k of u and v. So `H_k = 2s H_(k-1) - δ H_(k-2)`, and
    /// `p_k = (u^k + v^k)/2 = H_k - s H_(k-1)`. The sums `h_k` of κ₁ and κ₂ are `h_k = s h_(k-1) - d h_(k-2)`. Neither u nor v is beyond 4 in
    /// size, and no κ beyond `1 + √2`. So `H_k`, `p_k` and `h_k` are `(k + 1) 4^k` at most. From one term to the next these bounds over
    /// factorials fall by more than a half: the rest is twice the first one.
    pub(crate) fn short<N: Level>(at: &Equations<N>, pair: WavePair<N>) -> Products<N> {
        let WavePair { sum: s, product: d, square } = pair;
        let one = Ball::of(1.0);
        let terms = short_terms(N::TERMS);
        let mut sums = short_sums([s, d, square], terms);
        let count = terms as f64;
        let power = N::Word::of(2.0 * count).power_of_two() * N::Word::of(2.0 * (count + 1.0) * (1.0 + 1e-12));
        for (sum, first) in sums.iter_mut().zip(FIRSTS) {
            *sum = sum.widened(power * N::Word::of(RECIPROCAL_FACTORIALS[2 * terms + first][0]));
        }
        let [w, half_r, v, e, c2, c3, rest] = sums;
        let r = half_r.scaled(2.0);
        [w, r, v, e, half_r - at.coupling * e, one - d * rest, c2, c3, at.terms([r.mid.size(), e.mid.size()])]
    }

    /// By κ₁ and κ₂, where `δ >= 4d`.
    pub(crate) fn apart_by_roots<N: Level>(at: &Equations<N>, roots: Roots<N>) -> Products<N> {
        let [first, second, gap] = roots;
        let [[c1, s1, _, e1, c1_size, s1_size], [c2, s2, _, e2, c2_size, s2_size]] = [waves(first), waves(second)];
        let (sigma, t, inverse) = (at.sigma, at.coupling, gap.inverse());
        let (p, r, sc, cs) = (c1 * c2, s1 * s2, s1 * c2, c1 * s2);
        let variance = sigma * sigma;
        let (over_square, less) = (inverse * inverse, e1 * e2 - p);
        let e = (less + (first + second) * r.scaled(0.5)) * over_square;
        // R/2 - tE by δ = t² + 4hσ² and s = t - 2τh: strings have no other form without cancellation
        let product = at.tau * at.h;
        let difference = (((at.h * variance).scaled(2.0) + t * product) * r - t * less) * over_square;
        let (c1, s1, c2, s2) = (c1 * e2, s1 * e2, c2 * e1, s2 * e1);
        // 2σ²E is (2σ² (1 - P) + σ²sR)/δ
        let both_c = c1_size.mid.size() * c2_size.mid.size();
        let both_s = s1_size.mid.size() * s2_size.mid.size();
        let of_r = (at.tau + variance * (first + second) * over_square).mid.size() * both_s;
        let of_p = (variance * over_square).scaled(2.0).mid.size() * both_c;
        [
            (first * sc - second * cs) * inverse,
            r,
            ((cs - sc) * inverse).scaled(0.5),
            e,
            difference,
            (first * s2 - second * s1) * inverse,
            (c1 - c2) * inverse,
            (s1 - s2) * inverse,
            size_of(of_r + of_p),
        ]
    }

    /// By `u/4` and `v/4`, where `δ < 4d`: `cosh √u = C² + u S²/4`, `sinh √u/√u = S C` and `(cosh √u - 1)/u = S²/2` of them.
    ///
    /// By F, G and H for these three, `R = 2(F_u - F_v)/(u - v)`, `W = (G_u + G_v)/2`, `V = (G_u - G_v)/(u - v)`, and `E = (H_u - H_v)/(u - v)`.
    /// The one of u and v that is larger in size is a sum, the other one is δ over it.
    pub(crate) fn together<N: Level>(at: &Equations<N>, pair: WavePair<N>) -> Products<N> {
        let WavePair { sum, product, square } = pair;
        let (zero, one, root) = (N::Word::of(0.0), Ball::of(1.0), product.root());
        // (u - v)/4
        let root = Ball::select(sum.mid.leading().is_less(zero), -root, root);
        let u = sum + root.scaled(2.0);
        let quarters = [u.scaled(0.25), (square * u.inverse()).scaled(0.25)];
        let [first, second] = [waves(quarters[0]), waves(quarters[1])];
        // all are times the same: e^-2x of the one that grows more
        let ahead = first[2] - second[2];
        let is_behind = ahead.mid.leading().is_less(zero);
        let factor = Ball::select(is_behind, -ahead, ahead).decay();
        let twice = factor * factor;
        let shares = [Ball::select(is_behind, twice, one), Ball::select(is_behind, one, twice)];
        let [f, g, h, c_size, s_size] = of_whole(quarters[0], first, shares[0]);
        let [other_f, other_g, other_h, other_c_size, other_s_size] = of_whole(quarters[1], second, shares[1]);
        let inverse = root.inverse();
        let (r, e) = (((f - other_f) * inverse).scaled(0.5), ((h - other_h) * inverse).scaled(0.25));
        let size = inverse.mid.size();
        let (half, quarter) = (size * N::Word::of(0.5), size * N::Word::of(0.25));
        let sizes =
            [(c_size.mid.size() + other_c_size.mid.size()) * half, (s_size.mid.size() + other_s_size.mid.size()) * quarter];
        let (a, b) = (first[0] * second[1] * factor, first[1] * second[0] * factor);
        let [one_first, one_second] = quarters;
        let (mostly_first, mostly_second) =
            (one_first.scaled(2.0) + one_first + one_second, one_first + one_second.scaled(2.0) + one_second);
        [
            (g + other_g).scaled(0.5),
            r,
            ((g - other_g) * inverse).scaled(0.25),
            e,
            r.scaled(0.5) - at.coupling * e,
            ((b * mostly_first - a * mostly_second) * inverse).scaled(0.5),
            (first[1] * second[1] * factor).scaled(0.5),
            ((a - b) * inverse).scaled(0.5),
            at.terms(sizes),
        ]
    }

    /// `cosh √κ` and `sinh √κ/√κ`, entire in κ, in the form that its size and its sign give.
    fn waves<N: Level>(kappa: Ball<N>) -> Waves<N> {
        let is_small = kappa.largest().is_less(N::Word::of(0.875));
        let is_positive = N::Word::not(kappa.mid.leading().is_less(N::Word::of(0.0)));
        let travels = N::Word::not(either::<N::Word>(is_small, is_positive));
        let (zero, one) = (Ball::of(0.0), Ball::of(1.0));
        of_forms::<N, 6>(
            [is_small, travels],
            |truth| small(Ball::select(truth, kappa, zero)),
            |truth| travelling(Ball::select(truth, -kappa, one)),
            |truth| growing(Ball::select(truth, kappa, one)),
        )
    }

    /// Those of a small κ.
    fn small<N: Level>(kappa: Ball<N>) -> Waves<N> {
        let [c, s] = kappa.series::<0, 2, 2, 14>();
        [c, s, Ball::of(0.0), Ball::of(1.0), size_of(c.mid.size()), size_of(s.mid.size())]
    }

    /// Those of a wave that travels, by -κ.
    fn travelling<N: Level>(square: Ball<N>) -> Waves<N> {
        let (phase, one) = (square.root(), Ball::of(1.0));
        let ([s, c], inverse) = (phase.sin_cos(), phase.inverse());
        [c, s * inverse, Ball::of(0.0), one, one, size_of(inverse.mid.size())]
    }

    /// Those of a wave that grows.
    fn growing<N: Level>(kappa: Ball<N>) -> Waves<N> {
        let (growth, one) = (kappa.root(), Ball::of(1.0));
        let decay = growth.decay();
        let square = decay * decay;
        let (c, s) = ((one + square).scaled(0.5), (one - square).scaled(0.5) * growth.inverse());
        [c, s, growth, decay, size_of(c.mid.size()), size_of(s.mid.size())]
    }

    /// `cosh √u`, `sinh √u/√u` and `(cosh √u - 1)/u` of the quarter of u and its waves, times a share, and the sizes of the first two.
    fn of_whole<N: Level>(quarter: Ball<N>, waves: Waves<N>, share: Ball<N>) -> [Ball<N>; 5] {
        let [c, s, _, _, c_size, s_size] = waves;
        let squared = s * s;
        let f = (c * c + quarter * squared) * share;
        let c_size = (c_size * c_size * share).mid.size().or_larger(f.mid.size());
        let s_size = ((s_size * s_size).scaled(0.5) * share).mid.size();
        [f, s * c * share, squared.scaled(0.5) * share, size_of(c_size), size_of(s_size)]
    }
}

impl<N: Level> Equations<N> {
    /// About the size of the terms of `τR + 2σ²E`, for those of R and E.
    #[inline(always)]
    fn terms(&self, [r, e]: [N::Word; 2]) -> Ball<N> {
        let (sigma, tau) = (self.sigma.mid.size(), self.tau.mid.size());
        size_of(tau * r + (sigma * sigma + sigma * sigma) * e)
    }
}

/// Numbers in the form of each lane: a form gets the truth where it is asked for, and its other lanes are not used.
#[inline(always)]
pub(crate) fn of_forms<N: Level, const K: usize>(
    [is_first, is_second]: [<N::Word as Word>::Mask; 2],
    first: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
    second: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
    third: impl Fn(<N::Word as Word>::Mask) -> [Ball<N>; K],
) -> [Ball<N>; K] {
    let is_third = N::Word::not(either::<N::Word>(is_first, is_second));
    let mut numbers = [Ball::of(0.0); K];
    if any::<N::Word>(is_first) {
        numbers = first(is_first);
    }
    if any::<N::Word>(is_second) {
        numbers = select_all(is_second, second(is_second), numbers);
    }
    if any::<N::Word>(is_third) {
        numbers = select_all(is_third, third(is_third), numbers);
    }
    numbers
}

/// A size that decides nothing, among balls.
#[inline(always)]
fn size_of<N: Level>(size: N::Word) -> Ball<N> {
    Ball::exactly(N::of_word(size))
}

/// Number of terms of the series of short waves: the first one that is left out is below the rounding of a number of `TERMS`.
pub(crate) const fn short_terms(of_squares: usize) -> usize {
    of_squares + of_squares / 3 + 1
}

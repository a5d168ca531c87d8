//! The functions of the two squared wave numbers of a general beam.

use crate::number::even_waves::EvenWaves;
use crate::number::{Scalar, Size, Truth, twice};

/// The squared wave numbers κ₁, κ₂ of a beam, times l², by their sum s, their product d and `δ = (κ₁ - κ₂)² = s² - 4d`.
///
/// All functions of the pair are symmetric in both, and so entire in s and d. They are divided differences, taken in a form whose divisor
/// is not small: where κ₁ and κ₂ coincide, `u = (√κ₁ + √κ₂)²` and `v = (√κ₁ - √κ₂)²` are apart, and where these do, κ₁ and κ₂ are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WavePair<S> {
    /// `s = κ₁ + κ₂`.
    pub(crate) sum: S,
    /// `d = κ₁ κ₂`.
    pub(crate) product: S,
    /// `δ = (κ₁ - κ₂)²`, which a beam knows without cancellation.
    pub(crate) square: S,
}

/// The form in which functions of a pair are taken.
pub(super) enum Form<S> {
    /// Series, where both are small.
    Short,
    /// κ₁, κ₂ and `κ₁ - κ₂`.
    Apart { squares: [S; 2], difference: S },
    /// `u/4`, `v/4` and `(u - v)/4 = √d`.
    Together { quarters: [S; 2], difference: S },
}

/// A pair in its form, with the functions of the two numbers by which it is taken.
pub(super) enum PairWaves<S> {
    Short(WavePair<S>),
    Apart { sum: S, squares: [S; 2], difference: S, waves: [EvenWaves<S>; 2] },
    Together { sum: S, quarters: [S; 2], difference: S, waves: [EvenWaves<S>; 2] },
}

/// With `C = cosh √κ` and `S = sinh √κ/√κ` of both: `P = C₁ C₂`, `W = (κ₁ S₁ C₂ - κ₂ C₁ S₂)/(κ₁ - κ₂)`, `R = S₁ S₂`,
/// `V = (C₁ S₂ - S₁ C₂)/(2 (κ₁ - κ₂))` and `E = (1 - P + s R/2)/δ`, all divided by `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairProducts<S: Scalar> {
    pub(crate) p: S,
    pub(crate) w: S,
    pub(crate) r: S,
    pub(crate) v: S,
    pub(crate) e: S,
    /// 1, divided by the same power.
    pub(crate) one: S,
    /// `1/δ`, where δ is not small.
    pub(crate) inverse_square: Option<S>,
    pub(crate) exponent: i32,
}

/// `c₀..c₃` of `exp A = c₀ + c₁ A + c₂ A² + c₃ A³` for a matrix with the eigenvalues `±√κ₁, ±√κ₂`, all divided by `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairFunctions<S> {
    pub(crate) c: [S; 4],
    pub(crate) exponent: i32,
}

/// Sizes of s and of `√d` up to which functions are series.
const SHORT: [f64; 2] = [2.0, 1.0];

/// Number of terms of a series. `1/n!` is known up to `n = 40`.
fn terms<S: Scalar>() -> usize {
    (2 * S::SERIES_TERMS).min(19)
}

impl<S: Scalar> WavePair<S> {
    /// About the largest wave number times l, of whatever kind.
    pub(crate) fn largest_size(&self) -> f64 {
        let [sum, product] = [self.sum, self.product].map(|number| number.size().first());
        let root = |number: f64| S::from_f64(number).sqrt().size().first();
        root(sum.max(root(product)))
    }

    /// The form whose divisors are not small. Lanes have one form, or are not numbers.
    #[inline]
    pub(super) fn form(&self) -> Form<S> {
        let WavePair { sum, product, square } = *self;
        let is_short = sum.size().is_below(S::Size::of(SHORT[0])) & product.size().is_below(S::Size::of(SHORT[1]));
        if is_short.all() {
            return Form::Short;
        }
        // of real numbers: δ >= 4d
        let is_larger = !square.size().is_below(S::Size::of(4.0) * product.size());
        let is_apart = product.is_negative() | (is_larger & !square.is_negative());
        if is_apart.any() {
            let root = square.valid_if(is_apart & !is_short).sqrt();
            let (larger, difference) = larger_sum(sum, root);
            let larger = larger.times_power_of_two(-1);
            return Form::Apart { squares: [larger, product / larger], difference };
        }
        let root = product.valid_if(!is_short).sqrt();
        let (larger, twice_root) = larger_sum(sum, twice(root));
        let quarter = |number: S| number.times_power_of_two(-2);
        Form::Together {
            quarters: [quarter(larger), quarter(square / larger)],
            difference: twice_root.times_power_of_two(-1),
        }
    }

    /// The pair with the functions of the numbers of its form.
    #[inline]
    pub(super) fn in_form(&self) -> PairWaves<S> {
        let sum = self.sum;
        match self.form() {
            Form::Short => PairWaves::Short(*self),
            Form::Apart { squares, difference } => {
                PairWaves::Apart { sum, squares, difference, waves: squares.map(S::even_waves) }
            }
            Form::Together { quarters, difference } => {
                PairWaves::Together { sum, quarters, difference, waves: quarters.map(S::even_waves) }
            }
        }
    }
}

impl<S: Scalar> PairWaves<S> {
    /// The products of which the minors of a transfer matrix are made.
    #[inline]
    pub(super) fn products(&self) -> PairProducts<S> {
        match *self {
            PairWaves::Short(pair) => pair.short_products(),
            PairWaves::Apart { sum, squares, difference, waves: [first, second] } => {
                let one = first.one * second.one;
                let (p, r) = (first.cosh * second.cosh, first.sinhc * second.sinhc);
                let (cs, sc) = (first.cosh * second.sinhc, first.sinhc * second.cosh);
                let inverse = S::one() / difference;
                let inverse_square = inverse * inverse;
                PairProducts {
                    p,
                    r,
                    v: ((cs - sc) * inverse).times_power_of_two(-1),
                    w: (squares[0] * sc - squares[1] * cs) * inverse,
                    e: (one - p + (sum * r).times_power_of_two(-1)) * inverse_square,
                    one,
                    inverse_square: Some(inverse_square),
                    exponent: first.exponent.saturating_add(second.exponent),
                }
            }
            PairWaves::Together { quarters, difference, waves, .. } => products_together(quarters, waves, difference),
        }
    }

    /// The functions of which a transfer matrix is made.
    pub(super) fn functions(&self) -> PairFunctions<S> {
        match *self {
            PairWaves::Short(pair) => PairFunctions { c: pair.short_functions(), exponent: 0 },
            PairWaves::Apart { squares, difference, waves: [first, second], .. } => {
                let exponent = first.exponent.max(second.exponent);
                let [[c1, s1], [c2, s2]] = [first, second].map(|waves| {
                    [waves.cosh, waves.sinhc].map(|entry| entry.times_power_of_two(waves.exponent - exponent))
                });
                let inverse = S::one() / difference;
                let c0 = (squares[0] * c2 - squares[1] * c1) * inverse;
                let c1_of_a = (squares[0] * s2 - squares[1] * s1) * inverse;
                PairFunctions { c: [c0, c1_of_a, (c1 - c2) * inverse, (s1 - s2) * inverse], exponent }
            }
            PairWaves::Together { sum, quarters, difference, waves: [first, second] } => {
                let half = |number: S| number.times_power_of_two(-1);
                let inverse = S::one() / difference;
                let (cs, sc) = (first.cosh * second.sinhc, first.sinhc * second.cosh);
                let c2 = half(first.sinhc * second.sinhc);
                let c3 = half((cs - sc) * inverse);
                let half_sum = half(sum);
                let c0 = first.cosh * second.cosh - half_sum * c2;
                let c1 = (quarters[0] * sc - quarters[1] * cs) * inverse - half_sum * c3;
                PairFunctions { c: [c0, c1, c2, c3], exponent: first.exponent.saturating_add(second.exponent) }
            }
        }
    }
}

impl<S: Scalar> WavePair<S> {
    /// Series of the products: with the complete homogeneous sums `H_k` of u and v, `H_k = 2s H_(k-1) - δ H_(k-2)`, and
    /// `p_k = H_k - s H_(k-1)`.
    fn short_products(&self) -> PairProducts<S> {
        let twice_sum = twice(self.sum);
        let (mut before, mut last) = (S::zero(), S::one());
        let zero = S::zero();
        let (mut p, mut w, mut r, mut v, mut e) = (zero, zero, zero, zero, zero);
        for k in 0..terms::<S>() {
            let power = last - self.sum * before;
            p += power * S::reciprocal_factorial(2 * k);
            w += power * S::reciprocal_factorial(2 * k + 1);
            r += last * S::reciprocal_factorial(2 * k + 2);
            v += last * S::reciprocal_factorial(2 * k + 3);
            e += last * S::reciprocal_factorial(2 * k + 4);
            (before, last) = (last, twice_sum * last - self.square * before);
        }
        PairProducts { p, w, r: twice(r), v, e, one: S::one(), inverse_square: None, exponent: 0 }
    }

    /// Series of the functions: with the complete homogeneous sums `h_k` of κ₁ and κ₂, `h_k = s h_(k-1) - d h_(k-2)`.
    fn short_functions(&self) -> [S; 4] {
        let (mut before, mut last) = (S::zero(), S::one());
        let mut sums = [S::zero(); 4];
        for k in 0..terms::<S>() - 1 {
            for (number, sum) in sums.iter_mut().enumerate() {
                *sum += last * S::reciprocal_factorial(2 * k + 2 + number);
            }
            (before, last) = (last, self.sum * last - self.product * before);
        }
        let [second, third, fourth, fifth] = sums;
        [S::one() - self.product * fourth, S::one() - self.product * fifth, second, third]
    }
}

/// The sum of two numbers or their difference, whichever is larger, and the second number with the sign that it has there.
#[inline]
pub(super) fn larger_sum<S: Scalar>(first: S, second: S) -> (S, S) {
    let (sum, difference) = (first + second, first - second);
    let is_sum = !sum.size().is_below(difference.size());
    (S::select(is_sum, sum, difference), S::select(is_sum, second, -second))
}

/// The products by the functions of whole u and v, from those of their quarters: `cosh √u = C² + u S²/4`, `sinh √u/√u = S C`,
/// `(cosh √u - 1)/u = S²/2`.
#[inline]
fn products_together<S: Scalar>(
    quarters: [S; 2],
    [first, second]: [EvenWaves<S>; 2],
    difference: S,
) -> PairProducts<S> {
    let exponent = first.exponent.max(second.exponent).saturating_mul(2);
    let whole = |quarter: S, waves: EvenWaves<S>| {
        let squared = waves.sinhc * waves.sinhc;
        let power = waves.exponent.saturating_mul(2) - exponent;
        let entries = [waves.cosh * waves.cosh + quarter * squared, waves.sinhc * waves.cosh, squared];
        if power == 0 { entries } else { entries.map(|entry| entry.times_power_of_two(power)) }
    };
    let [fu, gu, hu] = whole(quarters[0], first);
    let [fv, gv, hv] = whole(quarters[1], second);
    let inverse = S::one() / difference;
    PairProducts {
        p: (fu + fv).times_power_of_two(-1),
        w: (gu + gv).times_power_of_two(-1),
        r: ((fu - fv) * inverse).times_power_of_two(-1),
        v: ((gu - gv) * inverse).times_power_of_two(-2),
        e: ((hu - hv) * inverse).times_power_of_two(-3),
        one: S::one().times_power_of_two(-exponent),
        inverse_square: None,
        exponent,
    }
}

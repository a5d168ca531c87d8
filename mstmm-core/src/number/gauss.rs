//! Integrals along an element by Gauss's rule.

use crate::number::{Real, Scalar};

/// Nodes and weights of Gauss and Legendre on `[-1, 1]`, exact up to degree 13. They are exact to rounding for a product of two
/// deflections whose phase changes by less than 1 over the interval.
const GAUSS: [(f64, f64); 7] = [
    (-0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
    (-0.741_531_185_599_394_4, 0.279_705_391_489_276_7),
    (-0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.0, 0.417_959_183_673_469_4),
    (0.405_845_151_377_397_2, 0.381_830_050_505_118_9),
    (0.741_531_185_599_394_4, 0.279_705_391_489_276_7),
    (0.949_107_912_342_758_5, 0.129_484_966_168_869_7),
];

/// The integrals over the length of an element, on as many pieces as there are waves, of the numbers that are known at each distance.
pub(crate) fn integrals<T: Real, S: Scalar + core::ops::Mul<T, Output = S>, const N: usize>(
    length: T,
    waves: f64,
    at: impl Fn(T) -> [S; N],
) -> [S; N] {
    let mut sums = [S::zero(); N];
    add_part(&mut sums, [T::zero(), length], waves, &at);
    sums
}

/// A wave along an element: its number times the length, and how many powers of e it decays by along the length.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Decaying {
    pub(crate) number: f64,
    pub(crate) decay: f64,
}

impl Decaying {
    /// The larger number and the smaller decay of two waves.
    pub(crate) fn beside(self, other: Self) -> Self {
        Decaying { number: self.number.max(other.number), decay: self.decay.min(other.decay) }
    }
}

/// The power of e by which a wave beside an end has decayed to less than the rounding of its integral.
const DECAYED: f64 = 40.0;

/// The integrals over the length of an element of two waves, the shorter one first. Where a wave has decayed it needs no pieces, so that their
/// number does not grow with it.
pub(crate) fn integrals_beside_ends<T: Real, S: Scalar + core::ops::Mul<T, Output = S>, const N: usize>(
    length: T,
    [shorter, longer]: [Decaying; 2],
    at: impl Fn(T) -> [S; N],
) -> [S; N] {
    if shorter.decay <= 2.0 * DECAYED {
        return integrals(length, shorter.number, at);
    }
    // shares of the length at which first the shorter wave and then the longer one has decayed
    let first = DECAYED / shorter.decay;
    let second = if longer.decay > 2.0 * DECAYED { (DECAYED / longer.decay).max(first) } else { 0.5 };
    let mut sums = [S::zero(); N];
    let parts = [
        (0.0, first, shorter.number),
        (first, second, longer.number),
        (second, 1.0 - second, 0.0),
        (1.0 - second, 1.0 - first, longer.number),
        (1.0 - first, 1.0, shorter.number),
    ];
    for (from, to, number) in parts.into_iter().filter(|(from, to, _)| from < to) {
        let ends = [from, to].map(|share| length * T::from_f64(share));
        add_part(&mut sums, ends, number * (to - from), &at);
    }
    sums
}

/// Adds the integrals over a part of an element, on as many pieces as there are waves.
fn add_part<T: Real, S: Scalar + core::ops::Mul<T, Output = S>, const N: usize>(
    sums: &mut [S; N],
    [from, to]: [T; 2],
    waves: f64,
    at: &impl Fn(T) -> [S; N],
) {
    let pieces = 1 + waves as u32;
    let half = (to - from) / T::from_f64(2.0 * f64::from(pieces));
    for piece in 0..pieces {
        let middle = from + half * T::from_f64(f64::from(2 * piece + 1));
        for (node, weight) in GAUSS {
            let width = half * T::from_f64(weight);
            for (sum, number) in sums.iter_mut().zip(at(middle + half * T::from_f64(node))) {
                *sum += number * width;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Closed form: the integrals of `(e^{-ax} + e^{-a(1-x)}) cos bx` and of `e^{-2ax}`, on few pieces however short the waves are.
    #[test]
    fn waves_beside_ends_need_few_pieces() {
        use std::cell::Cell;
        for (a, b) in [(50.0, 3.0), (90.0, 3.0), (1e3, 3.0), (1e7, 3.0), (1e7, 25.0), (300.0, 0.1)] {
            let count = Cell::new(0);
            let waves = [Decaying { number: a, decay: a }, Decaying { number: b, decay: 0.0 }];
            let [mixed, square] = integrals_beside_ends(1.0, waves, |x: f64| {
                count.set(count.get() + 1);
                let (input, output) = ((-a * x).exp(), (-a * (1.0 - x)).exp());
                [(input + output) * (b * x).cos(), input * input]
            });
            let sum: f64 = a * a + b * b;
            let decayed = (-a).exp();
            let expected =
                (a + decayed * (b * b.sin() - a * b.cos())) / sum + (a * b.cos() + b * b.sin() - decayed * a) / sum;
            // a distance from the output end has the rounding of 1
            let rounding = 1e-14 * (1.0 + b) + f64::EPSILON * a;
            assert!((mixed - expected).abs() < rounding * a / sum, "{a} {b}: {mixed} {expected}");
            let expected = (1.0 - decayed * decayed) / (2.0 * a);
            assert!((square - expected).abs() < 1e-14 * expected, "{a} {b}: {square} {expected}");
            assert!(count.get() < 7 * (100 + b as usize), "{a} {b}: {}", count.get());
        }
    }
}

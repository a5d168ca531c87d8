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
    let pieces = 1 + waves as u32;
    let half = length / T::from_f64(2.0 * f64::from(pieces));
    let mut sums = [S::zero(); N];
    for piece in 0..pieces {
        let middle = half * T::from_f64(f64::from(2 * piece + 1));
        for (node, weight) in GAUSS {
            let width = half * T::from_f64(weight);
            for (sum, number) in sums.iter_mut().zip(at(middle + half * T::from_f64(node))) {
                *sum += number * width;
            }
        }
    }
    sums
}

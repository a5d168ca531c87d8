//! Samples of Δ, and what is interpolated between them.

use crate::number::{Packed, Scalar, Size};

/// Halvings of a bracket: a cubic through samples is no better.
const HALVINGS: u32 = 12;

/// A point at the square root s of a frequency, in which the frequencies of beams are evenly spaced, and Δ there over a power of two.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Point {
    pub(super) s: f64,
    pub(super) value: f64,
}

/// A sample of a window.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sample {
    pub(super) point: Point,
    /// Number of roots below.
    pub(super) below: f64,
    /// That number with a share of the next root: it grows evenly, as the phase of a wave.
    pub(super) phase: f64,
}

/// A real number, or several in lanes, with the arithmetic of an approach.
pub(super) trait Real: Packed<f64> + Scalar<Size = Self, Truth = <Self as Size>::Truth> + Size {}

impl<S: Packed<f64> + Scalar<Size = S, Truth = <S as Size>::Truth> + Size> Real for S {}

/// The value at zero of the polynomial through points, by Lagrange's weights: their quotients do not wait for each other.
#[inline(always)]
pub(super) fn at_zero<S: Real, const N: usize>(x: [S; N], y: [S; N]) -> S {
    let mut sum = S::zero();
    let mut k = 0;
    while k < N {
        let (mut above, mut below) = (y[k], S::one());
        let mut j = 0;
        while j < N {
            if j != k {
                above *= x[j];
                below *= x[j] - x[k];
            }
            j += 1;
        }
        sum += above / below;
        k += 1;
    }
    sum
}

/// About `exp(-8y)`: any smooth factor has the same zeros.
#[inline(always)]
pub(super) fn without_growth<S: Real>(y: S) -> S {
    let eighth = S::one() - y * (S::one() - y * <S as Size>::of(0.5));
    let quarter = eighth * eighth;
    let half = quarter * quarter;
    half * half
}

/// The zero, from the begin of a bracket on, of the cubic through four samples of Δ without its growth; none if these are not known.
pub(super) fn zero_among(near: &[Sample; 4], first: f64, [begin, end]: [Point; 2], growth: f64) -> Option<f64> {
    let scale = first.recip();
    let mut x = [0.0; 4];
    let mut y = [0.0; 4];
    for (k, sample) in near.iter().enumerate() {
        x[k] = sample.point.s - begin.s;
        let value = if x[k] == 0.0 { first } else { sample.point.value };
        y[k] = value * scale * without_growth(x[k] * growth * 0.125);
    }
    // divided differences
    for order in 1..4 {
        for k in (order..4).rev() {
            y[k] = (y[k] - y[k - 1]) / (x[k] - x[k - order]);
        }
    }
    let cubic = |s: f64| ((y[3] * (s - x[2]) + y[2]) * (s - x[1]) + y[1]) * (s - x[0]) + y[0];
    let (mut lower, mut upper) = (0.0, end.s - begin.s);
    if !(cubic(lower) > 0.0 && cubic(upper) < 0.0) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = (lower + upper) * 0.5;
        if cubic(middle) > 0.0 { lower = middle } else { upper = middle }
    }
    Some((lower + upper) * 0.5)
}

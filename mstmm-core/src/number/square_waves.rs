//! How the even functions of waves are computed, of real and of complex squares, with their slopes.

use crate::number::even_waves::EvenWaves;
use crate::number::frequency::Real;
use crate::number::scalar::{Scalar, series};
use crate::number::truth::{Size, Truth};
use crate::number::waves::scaled_hyperbolic;
use num_complex::Complex;

#[cfg(test)]
mod tests;

impl<T: Real> EvenWaves<T> {
    /// Those of a real square.
    #[inline(always)]
    pub fn of_real(square: T) -> Self {
        let size = square.size();
        if size <= 1.0 {
            return EvenWaves::of_short(square);
        }
        let root = square.abs().sqrt();
        if square < T::zero() {
            let [sin, cos] = root.circular();
            return EvenWaves::unscaled(cos, sin / root);
        }
        let ([sh, ch], exponent) = scaled_hyperbolic(root);
        EvenWaves { cosh: ch, sinhc: sh / root, one: T::one().times_power_of_two(-exponent), exponent }
    }
}

impl<T: Real> EvenWaves<Complex<T>> {
    /// Those of a complex square.
    pub(crate) fn of_complex(square: Complex<T>) -> Self {
        if square.size() <= 1.0 {
            return EvenWaves::of_short(square);
        }
        let root = Scalar::sqrt(square);
        let ([sh, ch], exponent) = scaled_hyperbolic(root.re);
        let [sin, cos] = root.im.circular();
        EvenWaves {
            cosh: Complex::new(ch * cos, sh * sin),
            sinhc: Complex::new(sh * cos, ch * sin) / root,
            one: Complex::from_f64(1.0).times_power_of_two(-exponent),
            exponent,
        }
    }
}

impl<S: Scalar> EvenWaves<S> {
    /// Those that need no power of two.
    #[inline(always)]
    pub(crate) fn unscaled(cosh: S, sinhc: S) -> Self {
        EvenWaves { cosh, sinhc, one: S::one(), exponent: 0 }
    }

    /// Those of a square of at most 1, by their series.
    #[inline(always)]
    pub(crate) fn of_short(square: S) -> Self {
        EvenWaves::unscaled(series(square, 0, 2), series(square, 1, 2))
    }

    /// Derivatives of both with respect to the square, `C' = S/2` and `S' = (C - S)/2κ`, divided by the same power of two.
    #[inline(always)]
    pub(crate) fn slopes(&self, square: S) -> [S; 2] {
        let half = S::from_f64(0.5);
        let is_long = S::Size::of(1.0).is_below(square.size());
        let closed = |waves: &Self| (waves.cosh - waves.sinhc) * half / square;
        let slope = if is_long.all() {
            closed(self)
        } else if is_long.any() {
            S::select(is_long, closed(self), short_slope(square))
        } else {
            short_slope(square)
        };
        [self.sinhc * half, slope]
    }
}

/// The derivative of `sinh √κ / √κ` for a square of at most 1: `Σ_k (k + 1) κ^k / (2k + 3)!`.
#[inline(always)]
fn short_slope<S: Scalar>(square: S) -> S {
    let term = |k: usize| S::reciprocal_factorial(2 * k + 3) * S::from_f64((k + 1) as f64);
    let last = 2 * S::SERIES_TERMS - 2;
    let mut sum = term(last);
    for k in (0..last).rev() {
        sum = sum * square + term(k);
    }
    sum
}

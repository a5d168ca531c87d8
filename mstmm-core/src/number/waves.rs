//! How the functions of bending waves are computed, of real and of complex arguments.

use crate::number::frequency::Real;
use crate::number::wave_functions::{WaveFunctions, WaveProducts};
use num_complex::Complex;

/// ln 2 in two parts; the first has trailing zeros, so that its multiples up to 2^20 are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// `sin x`, `cos x`, and `ch x`, `sh x` and 1 divided by `2^exponent`.
struct Functions<T> {
    sin: T,
    cos: T,
    ch: T,
    sh: T,
    one: T,
    exponent: i32,
}

impl<T: Real> Functions<T> {
    #[inline(always)]
    fn of(x: T) -> Self {
        let size = x.size();
        if size < T::WAVE_LIMIT { Functions::moderate(x) } else { Functions::beyond_limit(x, size) }
    }

    /// Below the limit.
    #[inline(always)]
    fn moderate(x: T) -> Self {
        let [sin, cos, sh, ch] = x.circular_and_hyperbolic();
        Functions { sin, cos, ch, sh, one: T::one(), exponent: 0 }
    }

    /// Here `exp(-2|x|)` does not count beside 1. An error of the scale is common to all and positive, so it is no error.
    #[cold]
    fn beyond_limit(x: T, size: f64) -> Self {
        let [sin, cos] = x.circular();
        let exponent = (size / core::f64::consts::LN_2) as i32;
        let k = T::from_f64(f64::from(exponent));
        let rest = (x.abs() - k * T::from_f64(LN_2[0])) - k * T::from_f64(LN_2[1]);
        let ch = rest.exp() * T::from_f64(0.5);
        let sh = if x < T::zero() { -ch } else { ch };
        Functions { sin, cos, ch, sh, one: T::one().times_power_of_two(-exponent), exponent }
    }
}

impl<T: Real> WaveProducts<T> {
    /// Of a real argument: what [`Scalar::wave_products`](super::Scalar::wave_products) of a real scalar returns.
    #[inline(always)]
    pub fn of_real(z: T) -> Self {
        Self::of_functions(Functions::of(z))
    }

    /// Of a real argument below [`WAVE_LIMIT`](super::Scalar::WAVE_LIMIT).
    #[inline(always)]
    pub fn of_moderate(z: T) -> Self {
        Self::of_functions(Functions::moderate(z))
    }

    #[inline(always)]
    fn of_functions(functions: Functions<T>) -> Self {
        let Functions { sin, cos, ch, sh, one, exponent } = functions;
        WaveProducts { ch_cos: ch * cos, ch_sin: ch * sin, sh_cos: sh * cos, sh_sin: sh * sin, one, exponent }
    }
}

impl<T: Real> WaveFunctions<T> {
    /// Of a real argument.
    pub(crate) fn of_real(z: T) -> Self {
        let Functions { sin, cos, ch, sh, one, exponent } = Functions::of(z);
        WaveFunctions { sin: sin * one, cos: cos * one, sh, ch, exponent }
    }
}

/// The functions of a complex argument from those of its parts, `[ch, sh, cos, sin]`; the former two are divided by the power
/// of two of the real part, the latter two by that of the imaginary part.
#[inline(always)]
fn of_parts<T: Real>(re: &Functions<T>, im: &Functions<T>) -> [Complex<T>; 4] {
    [
        Complex::new(re.ch * im.cos, re.sh * im.sin),
        Complex::new(re.sh * im.cos, re.ch * im.sin),
        Complex::new(re.cos * im.ch, -(re.sin * im.sh)),
        Complex::new(re.sin * im.ch, re.cos * im.sh),
    ]
}

impl<T: Real> WaveFunctions<Complex<T>> {
    /// Of a complex argument.
    pub(crate) fn of_complex(z: Complex<T>) -> Self {
        let (re, im) = (Functions::of(z.re), Functions::of(z.im));
        let [ch, sh, cos, sin] = of_parts(&re, &im);
        WaveFunctions {
            sin: sin * re.one,
            cos: cos * re.one,
            sh: sh * im.one,
            ch: ch * im.one,
            exponent: re.exponent.saturating_add(im.exponent),
        }
    }
}

impl<T: Real> WaveProducts<Complex<T>> {
    /// Of a complex argument: both parts oscillate and grow.
    #[inline(always)]
    pub(crate) fn of_complex(z: Complex<T>) -> Self {
        Self::of_functions(&Functions::of(z.re), &Functions::of(z.im))
    }

    /// Of a complex argument with both parts below [`WAVE_LIMIT`](super::Scalar::WAVE_LIMIT).
    #[inline(always)]
    pub(crate) fn of_moderate_complex(z: Complex<T>) -> Self {
        Self::of_functions(&Functions::moderate(z.re), &Functions::moderate(z.im))
    }

    #[inline(always)]
    fn of_functions(re: &Functions<T>, im: &Functions<T>) -> Self {
        let [ch, sh, cos, sin] = of_parts(re, im);
        WaveProducts {
            ch_cos: ch * cos,
            ch_sin: ch * sin,
            sh_cos: sh * cos,
            sh_sin: sh * sin,
            one: Complex::new(re.one * im.one, T::zero()),
            exponent: re.exponent.saturating_add(im.exponent),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::scalar::Scalar;
    use crate::number::tolerance::assert_close;

    #[test]
    fn real_and_complex_arguments_agree() {
        for z in [1.0, 3.7, 40.0, 99.9, 100.1, 5000.0_f64] {
            let (real, complex) = (z.wave_products(), Complex::new(z, 0.0).wave_products());
            assert_eq!((real.exponent, real.one), (complex.exponent, complex.one.re));
            for (a, b) in [
                (real.ch_cos, complex.ch_cos),
                (real.ch_sin, complex.ch_sin),
                (real.sh_cos, complex.sh_cos),
                (real.sh_sin, complex.sh_sin),
            ] {
                assert_close(a, b.re, a.abs(), 4.0);
                assert_eq!(b.im, 0.0);
            }
        }
    }

    #[test]
    fn the_scaled_form_continues_the_plain_one() {
        let z = 100.5_f64;
        let scaled = z.wave_products();
        // the argument itself carries half an eps of 100, and so does its exponential
        let scale = 2f64.powi(scaled.exponent);
        assert_close(scaled.ch_cos * scale, z.cosh() * z.cos(), z.cosh(), 200.0);
        assert_close(scaled.sh_sin * scale, z.sinh() * z.sin(), z.cosh(), 200.0);
    }

    #[test]
    fn a_swapped_sign_of_the_argument_swaps_that_of_the_odd_factors() {
        for z in [Complex::new(2.0, 1.5), Complex::new(150.0, -120.0)] {
            let (plus, minus) = (z.wave_products(), (-z).wave_products());
            for (a, b) in [
                (plus.ch_cos, minus.ch_cos),
                (plus.sh_sin, minus.sh_sin),
                (plus.ch_sin, -minus.ch_sin),
                (plus.sh_cos, -minus.sh_cos),
            ] {
                assert_close((a - b).size(), 0.0, a.size(), 4.0);
            }
        }
    }
}

//! How the functions of bending waves are computed, of real and of complex arguments.

use crate::number::frequency::Real;
use crate::number::wave_functions::WaveFunctions;
use num_complex::Complex;

/// ln 2 in two parts; the first has trailing zeros, so that its multiples up to 2^20 are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

impl<T: Real> WaveFunctions<T> {
    /// Wave functions of a real argument, as [`Scalar::wave_functions`](super::scalar::Scalar::wave_functions) returns them.
    #[inline(always)]
    pub fn of_real(z: T) -> Self {
        if z.size() < T::WAVE_LIMIT { WaveFunctions::of_moderate(z) } else { WaveFunctions::beyond_limit(z) }
    }

    /// Wave functions of a real argument below [`WAVE_LIMIT`](super::scalar::Scalar::WAVE_LIMIT).
    #[inline(always)]
    pub fn of_moderate(z: T) -> Self {
        let [sin, cos, sh, ch] = z.circular_and_hyperbolic();
        WaveFunctions { sin, cos, sh, ch, one: T::one(), exponents: [0; 2] }
    }

    /// Wave functions where `exp(-2|z|)` does not count beside 1.
    #[cold]
    fn beyond_limit(z: T) -> Self {
        let [sin, cos] = z.circular();
        let ([sh, ch], exponent) = hyperbolic_beyond_limit(z);
        WaveFunctions { sin, cos, sh, ch, one: T::one().times_power_of_two(-exponent), exponents: [0, exponent] }
    }
}

/// `[sinh z, cosh z]` of an argument of any size, and the power of two that is taken out of them.
#[inline]
pub(crate) fn scaled_hyperbolic<T: Real>(z: T) -> ([T; 2], i32) {
    if z.size() < T::WAVE_LIMIT { (z.hyperbolic(), 0) } else { hyperbolic_beyond_limit(z) }
}

/// The same where `exp(-2|z|)` does not count beside 1. An error of the scale is one positive factor of both.
#[cold]
fn hyperbolic_beyond_limit<T: Real>(z: T) -> ([T; 2], i32) {
    let exponent = (z.size() / core::f64::consts::LN_2) as i32;
    let k = T::from_f64(f64::from(exponent));
    let rest = (z.abs() - k * T::from_f64(LN_2[0])) - k * T::from_f64(LN_2[1]);
    let ch = rest.exp() * T::from_f64(0.5);
    let sh = if z < T::zero() { -ch } else { ch };
    ([sh, ch], exponent)
}

impl<T: Real> WaveFunctions<Complex<T>> {
    /// Wave functions of a complex argument, from those of its real and its imaginary part. Both kinds oscillate and grow.
    #[inline(always)]
    pub(crate) fn of_parts(re: &WaveFunctions<T>, im: &WaveFunctions<T>) -> Self {
        WaveFunctions {
            sin: Complex::new(re.sin * im.ch, re.cos * im.sh),
            cos: Complex::new(re.cos * im.ch, -(re.sin * im.sh)),
            sh: Complex::new(re.sh * im.cos, re.ch * im.sin),
            ch: Complex::new(re.ch * im.cos, re.sh * im.sin),
            one: Complex::new(re.one * im.one, T::zero()),
            exponents: [im.exponents[1], re.exponents[1]],
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
            let (real, complex) = (z.wave_functions(), Complex::new(z, 0.0).wave_functions());
            assert_eq!((real.exponents, real.one), (complex.exponents, complex.one.re));
            let pairs =
                [(real.sin, complex.sin), (real.cos, complex.cos), (real.sh, complex.sh), (real.ch, complex.ch)];
            for (a, b) in pairs {
                assert_close(a, b.re, a.abs(), 4.0);
                assert_eq!(b.im, 0.0);
            }
        }
    }

    #[test]
    fn the_scaled_form_continues_the_plain_one() {
        let z = 100.5_f64;
        let scaled = z.wave_functions();
        // the argument itself carries half an eps of 100, and so does its exponential
        let scale = 2f64.powi(scaled.exponents[1]);
        assert_close(scaled.ch * scale, z.cosh(), z.cosh(), 200.0);
        assert_close(scaled.sh * scale, z.sinh(), z.cosh(), 200.0);
        assert_close(scaled.one * scale, 1.0, 1.0, 0.0);
    }

    #[test]
    fn a_swapped_sign_of_the_argument_swaps_that_of_the_odd_functions() {
        for z in [Complex::new(2.0, 1.5), Complex::new(150.0, -120.0)] {
            let (plus, minus) = (z.wave_functions(), (-z).wave_functions());
            for (a, b) in [(plus.ch, minus.ch), (plus.cos, minus.cos), (plus.sh, -minus.sh), (plus.sin, -minus.sin)] {
                assert_close((a - b).size(), 0.0, a.size(), 4.0);
            }
        }
    }
}

//! Sine, cosine and their hyperbolic kin of one `f64` at once, or of several in lanes, without branches.
//!
//! Beams need all four of the same argument. Together they share their reductions, leave registers alone where calls to
//! a library would not, and are the same on every platform, with or without `std`. Polynomials of fdlibm (Sun
//! Microsystems, 1993) for sine and cosine, Taylor's for the exponential.

use core::ops::{Add, Mul, Sub};

/// π/2 in three parts; products of the first two with whole numbers below 2^20 are exact.
const HALF_PI: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// ln 2 in two parts; products of the first with whole numbers below 2^20 are exact.
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// Adding and subtracting this rounds to a whole number, which stands in the last bits in between.
pub(crate) const ROUNDER: f64 = 6_755_399_441_055_744.0;

const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// `1/n!` for even n from 2 and odd n from 3: `e^r` on `|r| <= ln 2 / 2`, even and odd part apart.
const EVEN: [f64; 6] = [1.0 / 2.0, 1.0 / 24.0, 1.0 / 720.0, 1.0 / 40_320.0, 1.0 / 3_628_800.0, 1.0 / 479_001_600.0];
const ODD: [f64; 6] =
    [1.0 / 6.0, 1.0 / 120.0, 1.0 / 5040.0, 1.0 / 362_880.0, 1.0 / 39_916_800.0, 1.0 / 6_227_020_800.0];

/// A number of the kernel: one `f64`, or several in lanes. The last bits of a number to which [`ROUNDER`] was added are a whole number.
pub(crate) trait Rounding: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// A number in all lanes.
    fn of(number: f64) -> Self;
    /// Sine and cosine of an angle from those of its rest, and the whole number of quarter turns in the last bits.
    fn turned(bits: Self, sin: Self, cos: Self) -> [Self; 2];
    /// `2^(k - 1)` and `2^(-k - 1)` for the whole number k in the last bits.
    fn halves_of_powers(bits: Self) -> [Self; 2];
}

impl Rounding for f64 {
    #[inline(always)]
    fn of(number: f64) -> Self {
        number
    }

    /// By bits and masks, since what quadrant it is cannot be predicted.
    #[inline(always)]
    fn turned(bits: Self, sin: Self, cos: Self) -> [Self; 2] {
        let (bits, sin, cos) = (bits.to_bits(), sin.to_bits(), cos.to_bits());
        let swap = (bits & 1).wrapping_neg() & (sin ^ cos);
        let (sin, cos) = (sin ^ swap, cos ^ swap);
        let (sin_sign, cos_sign) = ((bits & 2) << 62, (bits.wrapping_add(1) & 2) << 62);
        [f64::from_bits(sin ^ sin_sign), f64::from_bits(cos ^ cos_sign)]
    }

    #[inline(always)]
    fn halves_of_powers(bits: Self) -> [Self; 2] {
        // the low bits are k in two's complement
        let exponent = bits.to_bits() << 52;
        let half = 1022_u64 << 52;
        [f64::from_bits(half.wrapping_add(exponent)), f64::from_bits(half.wrapping_sub(exponent))]
    }
}

/// `Σ coefficients[k] x^k` of six terms, in pairs: a short chain of dependent operations.
#[inline(always)]
fn polynomial<K: Rounding>(coefficients: &[f64; 6], x: K) -> K {
    let [a, b, c, d, e, f] = *coefficients;
    let x2 = x * x;
    (K::of(a) + K::of(b) * x) + x2 * ((K::of(c) + K::of(d) * x) + x2 * (K::of(e) + K::of(f) * x))
}

/// `[sin x, cos x, sinh x, cosh x]` for `|x| <= 700`, sinh and cosh within 3 eps of their size, sine and cosine within 2 eps of 1.
#[inline(always)]
pub(crate) fn circular_and_hyperbolic<K: Rounding>(x: K) -> [K; 4] {
    let [sin, cos] = circular(x);
    let [sinh, cosh] = hyperbolic(x);
    [sin, cos, sinh, cosh]
}

/// Below this angle, 2^20 quarter turns, its reduction is exact.
pub(crate) const LARGEST_ANGLE: f64 = 1.6e6;

/// `[sin x, cos x]` for `|x|` below [`LARGEST_ANGLE`], within 2 eps of 1.
#[inline(always)]
pub(crate) fn circular<K: Rounding>(x: K) -> [K; 2] {
    let one = K::of(1.0);
    let bits = x * K::of(core::f64::consts::FRAC_2_PI) + K::of(ROUNDER);
    let quarters = bits - K::of(ROUNDER);
    // the sum of the last two parts is rounded at 1e-16 of the second, 1e-26 a quarter turn: far below an eps of 1
    let r = (x - quarters * K::of(HALF_PI[0])) - (quarters * K::of(HALF_PI[1]) + quarters * K::of(HALF_PI[2]));
    let z = r * r;
    let sin = r + r * (z * polynomial(&SINE, z));
    let half = K::of(0.5) * z;
    let near_one = one - half;
    let cos = near_one + (((one - near_one) - half) + z * (z * polynomial(&COSINE, z)));
    K::turned(bits, sin, cos)
}

/// `[sinh x, cosh x]` for `|x| <= 700`, within 3 eps of their size.
#[inline(always)]
pub(crate) fn hyperbolic<K: Rounding>(x: K) -> [K; 2] {
    let bits = x * K::of(core::f64::consts::LOG2_E) + K::of(ROUNDER);
    let doublings = bits - K::of(ROUNDER);
    let r = (x - doublings * K::of(LN_2[0])) - doublings * K::of(LN_2[1]);
    let z = r * r;
    let even = K::of(1.0) + z * polynomial(&EVEN, z);
    let odd = r + r * (z * polynomial(&ODD, z));
    let [up, down] = K::halves_of_powers(bits);
    let (sum, difference) = (up + down, up - down);
    [difference * even + sum * odd, sum * even + difference * odd]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::double_double::DoubleDouble;
    use crate::number::scalar::Scalar;
    use proptest::prelude::*;

    /// Oracle: the double-double functions, which have been held against 500 bits.
    fn check(x: f64) {
        let exact = DoubleDouble::from_f64(x);
        let ((sin, cos), (sinh, cosh)) = (exact.sin_cos(), exact.sinh_cosh());
        let found = circular_and_hyperbolic(x);
        // sinh is a difference of powers of two where x is next to ln 2: up to 2.8 eps in four million arguments
        let scales = [1.0, 1.0, 1.5 * sinh.size(), 1.5 * cosh.size()];
        for ((found, exact), scale) in found.into_iter().zip([sin, cos, sinh, cosh]).zip(scales) {
            let error = (DoubleDouble::from_f64(found) - exact).size();
            assert!(error <= 2.0 * f64::EPSILON * scale, "{x}: {found} is off by {} eps", error / f64::EPSILON / scale);
        }
    }

    proptest! {
        #[test]
        fn all_four_are_good_to_two_or_three_eps(x in -100.0..100.0f64, tiny in -1e-3..1e-3f64) {
            check(x);
            check(tiny);
        }

        #[test]
        fn sine_keeps_its_digits_near_multiples_of_pi(k in 1..30i32, offset in -1e-3..1e-3f64) {
            let x = f64::from(k) * core::f64::consts::PI + offset;
            let exact = DoubleDouble::from_f64(x).sin_cos().0;
            let error = (DoubleDouble::from_f64(circular_and_hyperbolic(x)[0]) - exact).size();
            // the reduced argument is rounded at 1e-26 a quarter turn; without the third part of π/2 it would be at 2e-21
            let reduction = 2.0 * f64::from(k) * 1e-26;
            prop_assert!(error <= 2.0 * f64::EPSILON * exact.size() + reduction, "{x}: {error:e}");
        }
    }

    proptest! {
        /// Oracle: the double-double functions.
        #[test]
        fn large_angles(x in -LARGEST_ANGLE..LARGEST_ANGLE) {
            let (sin, cos) = DoubleDouble::from_f64(x).sin_cos();
            for (found, exact) in circular(x).into_iter().zip([sin, cos]) {
                let error = (DoubleDouble::from_f64(found) - exact).size();
                prop_assert!(error <= 2.0 * f64::EPSILON, "{x}: {error:e}");
            }
        }
    }

    #[test]
    fn ends_of_the_range_and_zero() {
        for x in [0.0, -0.0, 1.0, 99.999, -99.999, 690.0, -690.0] {
            check(x);
        }
    }
}

//! Eight numbers by AVX-512.
#![expect(unsafe_code, reason = "values exist only on machines with AVX-512, see `Vector`")]

use crate::vector::{Part, Vector};
use core::arch::x86_64::*;

/// Eight numbers in a register of AVX-512.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Eight(__m512d);

/// The lanes that a slice of some length fills.
#[inline(always)]
fn filled(count: usize) -> u8 {
    if count >= 8 { 0xff } else { (1 << count) - 1 }
}

// SAFETY: by the contract of `Vector` the machine has AVX-512 F, DQ, BW and VL wherever a value exists; masked loads and stores touch
// the lanes alone that lie in the slice
impl Vector for Eight {
    const LANES: usize = 8;
    type Mask = u8;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        Eight(unsafe { _mm512_set1_pd(number) })
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        let last = numbers.last().copied().unwrap_or(0.0);
        Eight(unsafe { _mm512_mask_loadu_pd(_mm512_set1_pd(last), filled(numbers.len()), numbers.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        unsafe { _mm512_mask_storeu_pd(numbers.as_mut_ptr(), filled(numbers.len()), self.0) }
    }

    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        Eight(unsafe { _mm512_add_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn difference(self, other: Self) -> Self {
        Eight(unsafe { _mm512_sub_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Eight(unsafe { _mm512_mul_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn product_error(self, other: Self, product: Self) -> Self {
        Eight(unsafe { _mm512_fmsub_pd(self.0, other.0, product.0) })
    }

    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        Eight(unsafe { _mm512_div_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Eight(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        Eight(unsafe { _mm512_andnot_pd(_mm512_set1_pd(-0.0), self.0) })
    }

    #[inline(always)]
    fn root(self) -> Self {
        Eight(unsafe { _mm512_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn floor(self) -> Self {
        Eight(unsafe { _mm512_roundscale_pd::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(self.0) })
    }

    #[inline(always)]
    fn is_less(self, other: Self) -> u8 {
        unsafe { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self.0, other.0) }
    }

    #[inline(always)]
    fn has_minus(self) -> u8 {
        unsafe { _mm512_movepi64_mask(_mm512_castpd_si512(self.0)) }
    }

    #[inline(always)]
    fn is_nought(self) -> u8 {
        unsafe {
            let without_sign = _mm512_slli_epi64::<1>(_mm512_castpd_si512(self.0));
            _mm512_cmpeq_epi64_mask(without_sign, _mm512_setzero_si512())
        }
    }

    #[inline(always)]
    fn last_bit(self) -> u8 {
        unsafe { _mm512_test_epi64_mask(_mm512_castpd_si512(self.0), _mm512_set1_epi64(1)) }
    }

    #[inline(always)]
    fn select(truth: u8, first: Self, second: Self) -> Self {
        Eight(unsafe { _mm512_mask_blend_pd(truth, second.0, first.0) })
    }

    #[inline(always)]
    fn signed_by(self, bits: Self, added: i64) -> Self {
        unsafe {
            let bits = _mm512_add_epi64(_mm512_castpd_si512(bits.0), _mm512_set1_epi64(added));
            let sign = _mm512_slli_epi64::<62>(_mm512_and_si512(bits, _mm512_set1_epi64(2)));
            Eight(_mm512_xor_pd(self.0, _mm512_castsi512_pd(sign)))
        }
    }

    #[inline(always)]
    fn powers(self) -> [Self; 2] {
        unsafe {
            let exponent = _mm512_slli_epi64::<52>(_mm512_castpd_si512(self.0));
            let half = _mm512_set1_epi64(1022 << 52);
            let [up, down] = [_mm512_add_epi64(half, exponent), _mm512_sub_epi64(half, exponent)];
            [Eight(_mm512_castsi512_pd(up)), Eight(_mm512_castsi512_pd(down))]
        }
    }

    #[inline(always)]
    fn both(a: u8, b: u8) -> u8 {
        a & b
    }

    #[inline(always)]
    fn either(a: u8, b: u8) -> u8 {
        a | b
    }

    #[inline(always)]
    fn one_of(a: u8, b: u8) -> u8 {
        a ^ b
    }

    #[inline(always)]
    fn not(a: u8) -> u8 {
        !a
    }

    #[inline(always)]
    fn mask(truth: bool) -> u8 {
        if truth { 0xff } else { 0 }
    }

    #[inline(always)]
    fn bits(mask: u8) -> u8 {
        mask
    }

    #[inline(always)]
    fn call<P: Part>(part: P) -> P::Output {
        unsafe { called(part) }
    }
}

#[inline(never)]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn called<P: Part>(part: P) -> P::Output {
    part.run()
}

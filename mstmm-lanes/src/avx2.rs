//! Four numbers by AVX2.
#![expect(unsafe_code, reason = "values exist only on machines with AVX2, see `Vector`")]

use crate::vector::{Part, Vector};
use core::arch::x86_64::*;

/// Four numbers in a register of AVX2.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Four(__m256d);

/// Four truths: all bits of a lane are set where it is true.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct FourTruths(__m256i);

/// The lanes that a slice of some length fills.
#[inline(always)]
fn filled(count: usize) -> __m256i {
    // SAFETY: by the contract of `Vector` the machine has AVX2 and FMA
    unsafe { _mm256_cmpgt_epi64(_mm256_set1_epi64x(count.min(4) as i64), _mm256_setr_epi64x(0, 1, 2, 3)) }
}

// SAFETY: by the contract of `Vector` the machine has AVX2 and FMA wherever a value exists; masked loads and stores touch the lanes alone that
// lie in the slice
impl Vector for Four {
    const LANES: usize = 4;
    type Mask = FourTruths;

    #[inline(always)]
    fn splat(number: f64) -> Self {
        Four(unsafe { _mm256_set1_pd(number) })
    }

    #[inline(always)]
    fn load(numbers: &[f64]) -> Self {
        let last = Self::splat(numbers.last().copied().unwrap_or(0.0));
        let filled = filled(numbers.len());
        Self::select(FourTruths(filled), Four(unsafe { _mm256_maskload_pd(numbers.as_ptr(), filled) }), last)
    }

    #[inline(always)]
    fn store(self, numbers: &mut [f64]) {
        unsafe { _mm256_maskstore_pd(numbers.as_mut_ptr(), filled(numbers.len()), self.0) }
    }

    #[inline(always)]
    fn sum(self, other: Self) -> Self {
        Four(unsafe { _mm256_add_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn difference(self, other: Self) -> Self {
        Four(unsafe { _mm256_sub_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn product(self, other: Self) -> Self {
        Four(unsafe { _mm256_mul_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn product_error(self, other: Self, product: Self) -> Self {
        Four(unsafe { _mm256_fmsub_pd(self.0, other.0, product.0) })
    }

    #[inline(always)]
    fn quotient(self, other: Self) -> Self {
        Four(unsafe { _mm256_div_pd(self.0, other.0) })
    }

    #[inline(always)]
    fn negated(self) -> Self {
        Four(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        Four(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }

    #[inline(always)]
    fn root(self) -> Self {
        Four(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn floor(self) -> Self {
        Four(unsafe { _mm256_floor_pd(self.0) })
    }

    #[inline(always)]
    fn is_less(self, other: Self) -> FourTruths {
        FourTruths(unsafe { _mm256_castpd_si256(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0)) })
    }

    #[inline(always)]
    fn has_minus(self) -> FourTruths {
        FourTruths(unsafe { _mm256_cmpgt_epi64(_mm256_setzero_si256(), _mm256_castpd_si256(self.0)) })
    }

    #[inline(always)]
    fn is_nought(self) -> FourTruths {
        unsafe {
            let without_sign = _mm256_slli_epi64::<1>(_mm256_castpd_si256(self.0));
            FourTruths(_mm256_cmpeq_epi64(without_sign, _mm256_setzero_si256()))
        }
    }

    #[inline(always)]
    fn last_bit(self) -> FourTruths {
        unsafe {
            let last = _mm256_and_si256(_mm256_castpd_si256(self.0), _mm256_set1_epi64x(1));
            FourTruths(_mm256_sub_epi64(_mm256_setzero_si256(), last))
        }
    }

    #[inline(always)]
    fn select(truth: FourTruths, first: Self, second: Self) -> Self {
        Four(unsafe { _mm256_blendv_pd(second.0, first.0, _mm256_castsi256_pd(truth.0)) })
    }

    #[inline(always)]
    fn signed_by(self, bits: Self, added: i64) -> Self {
        unsafe {
            let bits = _mm256_add_epi64(_mm256_castpd_si256(bits.0), _mm256_set1_epi64x(added));
            let sign = _mm256_slli_epi64::<62>(_mm256_and_si256(bits, _mm256_set1_epi64x(2)));
            Four(_mm256_xor_pd(self.0, _mm256_castsi256_pd(sign)))
        }
    }

    #[inline(always)]
    fn powers(self) -> [Self; 2] {
        unsafe {
            let exponent = _mm256_slli_epi64::<52>(_mm256_castpd_si256(self.0));
            let half = _mm256_set1_epi64x(1022 << 52);
            let [up, down] = [_mm256_add_epi64(half, exponent), _mm256_sub_epi64(half, exponent)];
            [Four(_mm256_castsi256_pd(up)), Four(_mm256_castsi256_pd(down))]
        }
    }

    #[inline(always)]
    fn both(a: FourTruths, b: FourTruths) -> FourTruths {
        FourTruths(unsafe { _mm256_and_si256(a.0, b.0) })
    }

    #[inline(always)]
    fn either(a: FourTruths, b: FourTruths) -> FourTruths {
        FourTruths(unsafe { _mm256_or_si256(a.0, b.0) })
    }

    #[inline(always)]
    fn one_of(a: FourTruths, b: FourTruths) -> FourTruths {
        FourTruths(unsafe { _mm256_xor_si256(a.0, b.0) })
    }

    #[inline(always)]
    fn not(a: FourTruths) -> FourTruths {
        Self::one_of(a, Self::mask(true))
    }

    #[inline(always)]
    fn mask(truth: bool) -> FourTruths {
        FourTruths(unsafe { _mm256_set1_epi64x(if truth { -1 } else { 0 }) })
    }

    #[inline(always)]
    fn bits(mask: FourTruths) -> u8 {
        (unsafe { _mm256_movemask_pd(_mm256_castsi256_pd(mask.0)) }) as u8
    }

    #[inline(always)]
    fn call<P: Part>(part: P) -> P::Output {
        unsafe { called(part) }
    }
}

#[inline(never)]
#[target_feature(enable = "avx2,fma")]
fn called<P: Part>(part: P) -> P::Output {
    part.run()
}

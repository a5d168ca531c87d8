//! Exponents of floating-point numbers, from their bits.

/// Exponent `e` with `2^e <= size < 2^(e+1)`; 0 for zero and for what is not finite.
#[inline]
pub(crate) fn binary_exponent(size: f64) -> i32 {
    match biased_exponent(size) {
        0x7ff => 0,
        0 if size == 0.0 => 0,
        0 => biased_exponent(size * (1u64 << 54) as f64) - 1023 - 54,
        biased => biased - 1023,
    }
}

/// The exponent as it is stored: 0 for zero and subnormal numbers, `0x7ff` for what is not finite.
#[inline(always)]
pub(crate) fn biased_exponent(size: f64) -> i32 {
    ((size.to_bits() >> 52) & 0x7ff) as i32
}

/// `2^exponent` for a normal exponent, from its bits.
#[inline(always)]
pub(crate) fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(((1023 + i64::from(exponent)) as u64) << 52)
}

//! Taylor series of the functions of waves, for arguments where their closed forms cancel.

use crate::number::scalar::Scalar;

/// `2 [C, B, F, D, E]` of a beam's second compound as entire functions of `x = z⁴`, for `|x| <= 1`:
/// `2 ch c, (ch s + sh c)/z, sh s/z², (ch s - sh c)/z³, (1 - ch c)/z⁴`.
#[inline(always)]
pub(crate) fn short_wave_products<S: Scalar>(x: S) -> [S; 5] {
    let (two, four) = (S::from_f64(2.0), S::from_f64(4.0));
    let y = -(four * x);
    let mut series_of = [two; 5];
    let mut first = 0;
    // a loop and no closure, which would stand in another function than the lanes of vectors need
    while first < 5 {
        series_of[first] = series(y, first, 4);
        first += 1;
    }
    let [c, b, f, d, e] = series_of;
    [two * c, two * b, two * f, four * d, four * e]
}

/// `Σ_k x^k / (stride·k + first)!` by Horner's rule, from the last term that counts.
#[inline(always)]
pub(crate) fn series<S: Scalar>(x: S, first: usize, stride: usize) -> S {
    let last = S::SERIES_TERMS * 4 / stride - 1;
    let mut sum = S::reciprocal_factorial(stride * last + first);
    for k in (0..last).rev() {
        sum = sum * x + S::reciprocal_factorial(stride * k + first);
    }
    sum
}

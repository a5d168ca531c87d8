//! A frequency with its powers, computed once for all elements.

use crate::number::frequency::Frequency;
use crate::number::scalar::Scalar;

/// A frequency `x` as the steps of the plane method need it.
#[derive(Clone, Copy, Debug)]
pub struct FrequencyPowers<S> {
    /// The frequency itself: ω for a real scalar, λ for a complex one.
    pub x: S,
    /// λ².
    pub lambda_squared: S,
    /// `s, s², s³, s⁴` with `s² = ω = -iλ`: waves have a wave number proportional to s. Ones if no element has waves.
    pub powers: [S; 4],
    /// `1/s, 1/s², 1/s³, 1/s⁴`, likewise.
    pub inverse_powers: [S; 4],
}

impl<S: Scalar> FrequencyPowers<S> {
    /// The frequency `x`; its root is taken only if some element has waves.
    #[inline(always)]
    pub fn new<T>(x: S, waves: bool) -> Self
    where
        S: Frequency<T>,
    {
        let lambda_squared = x.lambda_squared();
        if !waves {
            return FrequencyPowers { x, lambda_squared, powers: [S::one(); 4], inverse_powers: [S::one(); 4] };
        }
        let s2 = x.omega();
        let s = s2.sqrt();
        let inverse = S::one() / s;
        let inverse2 = inverse * inverse;
        FrequencyPowers {
            x,
            lambda_squared,
            powers: [s, s2, s2 * s, -lambda_squared],
            inverse_powers: [inverse, inverse2, inverse2 * inverse, inverse2 * inverse2],
        }
    }
}

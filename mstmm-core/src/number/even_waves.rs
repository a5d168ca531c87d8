//! Hyperbolic cosine and sine of a square root, which are entire functions of the square.

/// `cosh √κ` and `sinh √κ / √κ`, both divided by `2^exponent`: waves of the square κ of a wave number, which decay where κ > 0 and travel where
/// κ < 0, `cos √-κ` and `sin √-κ / √-κ`.
#[derive(Clone, Copy, Debug)]
pub struct EvenWaves<S> {
    /// cosh √κ
    pub cosh: S,
    /// sinh √κ / √κ
    pub sinhc: S,
    /// `2^-exponent`: 1 beside the others.
    pub one: S,
    /// The power of two taken out, where `cosh √κ` would come near the end of the range.
    pub exponent: i32,
}

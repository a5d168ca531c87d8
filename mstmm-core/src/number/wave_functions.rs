//! Sine, cosine and their hyperbolic kin of one argument, free of overflow.

/// `sin z` and `cos z` divided by `2^j`, `sh z` and `ch z` divided by `2^k`.
///
/// Of a real argument j is zero, and k is where `ch z` would come near the end of the range.
#[derive(Clone, Copy, Debug)]
pub struct WaveFunctions<S> {
    /// sin z
    pub sin: S,
    /// cos z
    pub cos: S,
    /// sh z
    pub sh: S,
    /// ch z
    pub ch: S,
    /// `2^-(j + k)`: 1 beside a product of a circular and a hyperbolic function.
    pub one: S,
    /// j, the power of two taken out of the circular functions, and k, that out of the hyperbolic ones.
    pub exponents: [i32; 2],
}

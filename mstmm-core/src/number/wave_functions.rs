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

/// `ch z cos z`, `ch z sin z`, `sh z cos z`, `sh z sin z` and 1, all divided by `2^exponent`.
#[derive(Clone, Copy, Debug)]
pub struct WaveProducts<S> {
    /// ch z cos z
    pub ch_cos: S,
    /// ch z sin z
    pub ch_sin: S,
    /// sh z cos z
    pub sh_cos: S,
    /// sh z sin z
    pub sh_sin: S,
    /// 1
    pub one: S,
    /// The power of two taken out.
    pub exponent: i32,
}

impl<S: Copy + core::ops::Mul<Output = S>> WaveProducts<S> {
    /// The products of functions of one argument.
    #[inline(always)]
    pub(crate) fn of(waves: WaveFunctions<S>) -> Self {
        let WaveFunctions { sin, cos, sh, ch, one, exponents: [j, k] } = waves;
        let exponent = j.saturating_add(k);
        WaveProducts { ch_cos: ch * cos, ch_sin: ch * sin, sh_cos: sh * cos, sh_sin: sh * sin, one, exponent }
    }
}

//! Sines, cosines and their hyperbolic kin of one argument, and their products, free of overflow.

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

/// `sin z`, `cos z`, `sh z`, `ch z`, all divided by `2^exponent`.
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
    /// The power of two taken out.
    pub exponent: i32,
}

//! Random numbers by a fixed seed (xorshift).

pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
        for _ in 0..8 {
            random.bits();
        }
        random
    }

    pub(super) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// In [0, 1).
    pub(super) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// In [-1, 1).
    pub(super) fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Below a limit.
    pub(super) fn below(&mut self, limit: usize) -> usize {
        (self.bits() >> 20) as usize % limit
    }

    /// Of either sign, its decade uniform between ± this.
    pub(super) fn any_size(&mut self, decades: f64) -> f64 {
        let size = 10f64.powf(decades * self.signed());
        if self.below(2) == 0 { size } else { -size }
    }
}

//! Loads on all unknowns, under which no motion is at rest: shapes are sought with them.

use crate::number::{Scalar, binary_exponent, power_of_two};
use crate::structure::factor::{Factor, LoadEverywhere};

impl<S: Scalar> Factor<'_, S> {
    /// Adds what acts everywhere to the load of an unknown.
    pub(super) fn load_everywhere(&mut self, slot: usize) {
        let Some(LoadEverywhere { number, dislocates, .. }) = self.everywhere else { return };
        let unknown = &mut self.unknowns[slot];
        if unknown.is_loaded || (unknown.is_force && !dislocates) {
            return;
        }
        unknown.is_loaded = true;
        // loads of the size of the root of a stiffness, or of a flexibility, do equal works
        let unit = if unknown.size > 0.0 { power_of_two(binary_exponent(unknown.size) / 2) } else { 1.0 };
        for (next, load) in (number..).zip(&mut unknown.loads) {
            *load += S::from_f64(scattered([self.node, unknown.number, next]) * unit);
        }
    }
}

/// A number of the size of 1 that follows from three others without any order, so that loads of several numbers are independent on whatever
/// unknowns, and no motion is at rest under all of them.
fn scattered(from: [u32; 3]) -> f64 {
    let mut bits = 0_u64;
    for part in from {
        // the mixing steps of SplitMix64
        bits = bits.wrapping_add(u64::from(part)).wrapping_add(0x9E37_79B9_7F4A_7C15);
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
    }
    let part = (bits >> 33) as f64 / f64::from(1_u32 << 31);
    if part < 0.5 { part + 0.5 } else { -part }
}

//! What a pass in extended precision tells.

use crate::DoubleDouble;
use crate::number::Scaled;

/// Δ over a constant, which is that of stiffnesses in `f64`, and the number of natural frequencies below.
#[derive(Clone, Copy, Debug)]
pub struct PreciseCount {
    pub(crate) delta: Scaled<DoubleDouble>,
    pub(crate) below: u64,
}

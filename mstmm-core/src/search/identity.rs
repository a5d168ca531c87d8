//! Determinants that vanish identically.

use crate::model::SearchError;
use crate::number::Real;

/// Number of frequencies far from each other at which Δ must vanish to vanish identically: a degree of freedom is held twice, or a
/// massless one is not held.
const ZEROS: usize = 5;

/// Factor between such frequencies.
const FAR_APART: f64 = 3.0;

/// Refuses a system whose Δ vanishes at one frequency and at others far from it and from each other.
#[inline]
pub(crate) fn check_identity<T: Real>(mut size: T, mut vanishes_at: impl FnMut(T) -> bool) -> Result<(), SearchError> {
    for _ in 1..ZEROS {
        size *= T::from_f64(FAR_APART);
        if !vanishes_at(size) {
            return Ok(());
        }
    }
    Err(SearchError::Zero { points: ZEROS })
}

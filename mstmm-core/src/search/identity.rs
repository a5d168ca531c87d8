//! Determinants that vanish identically.

use crate::model::error::SearchError;
use crate::number::frequency::Real;

/// Frequencies far from each other at which Δ vanishes by no accident any more but identically: a degree of freedom is held
/// twice, or nothing holds a massless one.
const ZEROS: usize = 5;

/// Factor between such frequencies.
const FAR_APART: f64 = 3.0;

/// Gives up a search where Δ, which vanishes at one frequency, does so at others far from it and from each other, too.
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

//! Determinants that vanish identically.

use crate::model::{SearchError, Spot};
use crate::number::Real;

/// Number of frequencies far from each other at which Δ must vanish to vanish identically: a degree of freedom is held twice, or a
/// massless one is not held.
const ZEROS: usize = 5;

/// Factor between such frequencies.
const FAR_APART: f64 = 3.0;

/// Refuses a system whose Δ vanishes at one frequency and at others far from it and from each other, given whether it does at a
/// frequency, and where in a network that shows.
#[inline]
pub(crate) fn check_identity<T: Real>(
    mut size: T,
    mut vanishes_at: impl FnMut(T) -> (bool, Option<Spot>),
) -> Result<(), SearchError> {
    let mut at = None;
    for _ in 1..ZEROS {
        size *= T::from_f64(FAR_APART);
        let (vanishes, spot) = vanishes_at(size);
        if !vanishes {
            return Ok(());
        }
        at = spot.or(at);
    }
    Err(SearchError::Zero { points: ZEROS, at })
}

//! Sums that cancel, and the rounding in them.

use crate::number::{Scalar, largest_loss};
use crate::subspace::count::RootCounter;

/// A sum that cancels, with its rounding.
pub(crate) struct Remainder {
    /// The size to which the rounding of the sum is compared.
    pub(crate) size: f64,
    /// The size of the sum, or of another number in its unit that decides about the subspace; all digits are lost where it is rounding.
    pub(crate) whole: f64,
    /// The change of the sum by a unit in the last place of its terms.
    pub(crate) rounding: f64,
    /// The change of the sum by all roundings that its terms may carry.
    pub(crate) bound: f64,
}

impl Remainder {
    /// Reports a sum that lost too many digits to a counter. Returns whether it lost all.
    #[cold]
    pub(crate) fn tell<S: Scalar, C: RootCounter<S>>(self, counter: &mut C) -> bool {
        let is_nothing = self.whole <= self.bound;
        if is_nothing || self.rounding > largest_loss::<S>() * self.size {
            counter.cancelled(is_nothing);
        }
        is_nothing
    }
}

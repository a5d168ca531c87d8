//! Sums that cancel, and the rounding in them.

use crate::number::{Scalar, Size, Truth, largest_loss};
use crate::subspace::count::RootCounter;

/// A sum that cancels, with its rounding.
pub(crate) struct Remainder<Z> {
    /// The size to which the rounding of the sum is compared.
    pub(crate) size: Z,
    /// The size of the sum, or of another number in its unit that decides about the subspace; all digits are lost where it is rounding.
    pub(crate) whole: Z,
    /// The change of the sum by a unit in the last place of its terms.
    pub(crate) rounding: Z,
    /// The change of the sum by all roundings that its terms may carry.
    pub(crate) bound: Z,
}

impl<Z: Size> Remainder<Z> {
    /// Reports a sum that lost too many digits to a counter. Returns whether it lost all.
    #[cold]
    pub(crate) fn tell<S: Scalar<Size = Z>, C: RootCounter<S>>(self, counter: &mut C) -> Z::Truth {
        let is_nothing = !self.bound.is_below(self.whole);
        if (is_nothing | (self.size * Z::of(largest_loss::<S>())).is_below(self.rounding)).any() {
            counter.cancelled(is_nothing.any());
        }
        is_nothing
    }
}

//! What rounding leaves of sums that cancel.

use crate::number::doubt::largest_loss;
use crate::number::scalar::Scalar;
use crate::subspace::count::RootCounter;

/// What rounding leaves of a sum that cancels.
pub(crate) struct Remainder {
    /// Its size beside which its digits count.
    pub(crate) size: f64,
    /// Its own size, or that of what else decides about the subspace in its unit: where that is rounding nothing is left.
    pub(crate) whole: f64,
    /// What a last place of its terms makes of it.
    pub(crate) rounding: f64,
    /// What all roundings make of it that they may have gathered.
    pub(crate) estimate: f64,
}

impl Remainder {
    /// Tells a counter of a sum that lost too many digits. Returns whether it lost all.
    #[cold]
    pub(crate) fn tell<S: Scalar, C: RootCounter<S>>(self, counter: &mut C) -> bool {
        let is_nothing = self.whole <= self.estimate;
        if is_nothing || self.rounding > largest_loss::<S>() * self.size {
            counter.cancelled(is_nothing);
        }
        is_nothing
    }
}

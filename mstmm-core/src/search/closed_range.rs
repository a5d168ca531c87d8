//! Ranges that searches take: closed ones, since roots may lie on their ends.

use core::ops::RangeInclusive;

/// A range with both of its ends, `start..=end`.
#[diagnostic::on_unimplemented(
    message = "a range is searched with both of its ends, `start..=end`, and `{Self}` has not both",
    label = "write `start..=end`",
    note = "a root at an end of the range is in it: write `0.0..=100.0`, not `0.0..100.0`"
)]
pub trait ClosedRange<T> {
    /// Its two ends.
    #[doc(hidden)]
    fn closed(self) -> RangeInclusive<T>;
}

impl<T> ClosedRange<T> for RangeInclusive<T> {
    #[inline]
    fn closed(self) -> RangeInclusive<T> {
        self
    }
}

//! Attacks in full: families of models that searches without a proof answered wrongly, and counts a number at a time about points where
//! rounding decides. `once_wrong` has single cases of the same.
//!
//! Of each a sample runs with all tests. `cargo test --release --test spectrum attacks -- --ignored --nocapture` runs them in full, a row each.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod claims;
mod clusters;
mod columns;
mod double_points;
mod exact;
mod held;
mod held_members;
mod loads;
mod rods;

/// Makes a test of a sample and a long one of a function of a number of models.
macro_rules! in_full {
    ($($(#[$meta:meta])* $family:ident($sample:expr, $all:expr) = $some:ident, $every:ident;)*) => {$(
        $(#[$meta])*
        #[test]
        fn $some() {
            $family($sample);
        }

        $(#[$meta])*
        #[test]
        #[ignore = "long: .ci/long"]
        fn $every() {
            $family($all);
        }
    )*};
}
use in_full;

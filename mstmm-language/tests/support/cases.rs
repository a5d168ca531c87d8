//! How many cases a property is tried with.

use proptest::test_runner::Config;

/// A hundred, or as many as `PROPTEST_CASES` says.
pub(crate) fn cases() -> Config {
    match std::env::var_os("PROPTEST_CASES") {
        Some(_) => Config::default(),
        None => Config::with_cases(100),
    }
}

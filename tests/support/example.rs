//! Runs an example and reads what it prints.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use std::process::Command;

/// Where examples run, and what they write.
pub const FOLDER: &str = env!("CARGO_TARGET_TMPDIR");

/// What an example of the package prints.
pub fn printed(example: &str) -> String {
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml");
    let run = ["run", "--quiet", "--manifest-path", manifest, "--example", example];
    let output = Command::new(env!("CARGO")).args(run).current_dir(FOLDER).output().unwrap();
    assert!(output.status.success(), "{example}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The numbers in the rows of the table that a line starts.
pub fn rows_of(text: &str, start: &str) -> Vec<Vec<f64>> {
    let rows = text.lines().skip_while(|line| !line.trim_start().starts_with(start)).skip(1);
    let words = |line: &str| line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    rows.take_while(|line| !line.is_empty()).map(words).collect()
}

/// Asserts that a relative error keeps its limit.
pub fn assert_close(actual: f64, expected: f64, limit: f64) {
    let error = ((actual - expected) / expected).abs();
    assert!(error <= limit, "{actual} is not {expected}: {error:e}");
}

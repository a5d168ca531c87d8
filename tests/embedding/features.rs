//! The features `std` and `libm` add up: every combination compiles, but for none, which says what is missing.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use std::process::Command;

/// Checks mstmm alone, since a build together with its tests would switch `std` on; the errors it met.
fn errors(features: &str) -> Vec<String> {
    let output = Command::new(env!("CARGO"))
        .args(["check", "--locked", "--package", "mstmm", "--lib", "--color", "never"])
        .args(["--no-default-features", "--features", features])
        .args(["--target-dir", concat!(env!("CARGO_TARGET_TMPDIR"), "/features")])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    let shown = String::from_utf8(output.stderr).unwrap();
    let errors: Vec<String> = shown.lines().filter(|line| line.starts_with("error")).map(str::to_owned).collect();
    assert_eq!(output.status.success(), errors.is_empty(), "{shown}");
    errors
}

#[test]
#[ignore = "long: .ci/long"]
fn each_feature_and_both_compile() {
    for features in ["std", "libm", "std,libm"] {
        assert_eq!(errors(features), [""; 0], "{features}");
    }
}

/// The last line is cargo's own.
#[test]
#[ignore = "long: .ci/long"]
fn neither_is_one_error_that_names_them() {
    let expected = [
        "error: mstmm needs one of its features `std` (default) or `libm` for sin, cos and exp",
        "error: could not compile `mstmm-core` (lib) due to 1 previous error",
    ];
    assert_eq!(errors(""), expected);
}

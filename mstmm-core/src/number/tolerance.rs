//! The one tolerance of the tests: factor × eps × scale.

/// Asserts `|actual - expected| <= factor · eps · scale`; the message shows error ÷ bound.
#[track_caller]
pub(crate) fn assert_close(actual: f64, expected: f64, scale: f64, factor: f64) {
    let estimate = factor * f64::EPSILON * scale;
    let error = (actual - expected).abs();
    assert!(
        error <= estimate,
        "{actual} differs from {expected} by {error:e}, {} times the estimate",
        error / estimate
    );
}

//! A stiffness from the frequencies that it gives.

#[path = "../../../tests/support/example.rs"]
pub mod example;
#[expect(dead_code, reason = "the example's main")]
#[path = "../identification.rs"]
pub mod identification;

use example::{assert_close, printed};
use identification::{Measured, frequencies, identify};

/// Oracles: the stiffness that the frequencies are of, and the standard deviation by differences.
#[test]
fn a_known_stiffness_is_identified() {
    for clamp in [40.0, 900.0, 20_000.0] {
        let measured: Vec<_> = frequencies(clamp).unwrap().iter().map(|(hertz, _)| (*hertz, 1e-3 * hertz)).collect();
        let (found, deviation) = identify(Measured(measured.clone()), 1.5 * clamp).unwrap();
        assert_close(found, clamp, 1e-9);
        let step = 1e-4 * clamp;
        let [above, below] = [clamp + step, clamp - step].map(|clamp| frequencies(clamp).unwrap());
        let slopes = above.iter().zip(&below).map(|(above, below)| (above.0 - below.0) / (2.0 * step));
        let sum: f64 = slopes.zip(&measured).map(|(slope, (_, deviation))| (slope / deviation).powi(2)).sum();
        assert_close(deviation, 1.0 / sum.sqrt(), 1e-6);
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn the_program_prints_the_stiffness() {
    assert!(printed("identification").contains("stiffness of the clamp: "));
}

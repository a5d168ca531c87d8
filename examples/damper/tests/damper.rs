//! The damper against a closed form of the bridge and a scan.

#[expect(dead_code, reason = "the example's main")]
#[path = "../damper.rs"]
pub mod damper;
#[path = "../../../tests/support/example.rs"]
pub mod example;

use example::{assert_close, printed};
use mstmm::prelude::*;

/// Oracle: `Y/F = (tan(βl/2) - tanh(βl/2))/(4 EI β³)` of the bare bridge, the damper's dynamic stiffness, and a scan.
#[test]
fn the_damper_is_the_best_of_a_scan() {
    let guess = damper::bridge(56_371.0, 450.5);
    let omegas: Vec<f64> = (0..=4000).map(|step| 9.0 + 7.0 * f64::from(step) / 4000.0).collect();
    let bare: Vec<f64> = (omegas.iter())
        .map(|omega| {
            let beta = (omega * omega * guess.m / guess.ei).powf(0.25);
            ((beta * guess.half).tan() - (beta * guess.half).tanh()) / (4.0 * guess.ei * beta.powi(3))
        })
        .collect();
    let largest = |stiffness: f64, damping: f64| {
        let deflections = omegas.iter().zip(&bare).map(|(omega, bare)| {
            let (link, inertia) = (Complex::new(stiffness, omega * damping), -omega * omega * guess.mass);
            let damper = link * inertia / (link + inertia);
            (bare / (1.0 + bare * damper)).norm()
        });
        deflections.fold(0.0, f64::max)
    };
    let tuned = damper::tuned(&guess).unwrap();
    for bridge in [&guess, &tuned] {
        let deflection = damper::largest_deflection(bridge).unwrap();
        assert_close(deflection, largest(bridge.stiffness, bridge.damping), 2e-4);
    }
    let best = damper::largest_deflection(&tuned).unwrap();
    let steps = || (-20..=20).map(|step| f64::from(step) / 20.0);
    let scan = steps().flat_map(|k| steps().map(move |c| (k, c)));
    let scanned = scan.map(|(k, c)| largest(tuned.stiffness * (1.0 + 0.02 * k), tuned.damping * (1.0 + 0.3 * c)));
    assert_close(best, scanned.fold(f64::INFINITY, f64::min), 1e-3);
    assert!(best < 0.7 * damper::largest_deflection(&guess).unwrap());
}

#[test]
#[ignore = "long: .ci/long"]
fn the_program_prints_its_table() {
    assert!(printed("damper").contains("tuned"));
}

//! Static limits of responses, beside what nothing holds as well.
#![allow(missing_docs, reason = "models of a test")]
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use mstmm::prelude::*;
use mstmm::{DoubleDouble, MotionError};

system! {
    /// A mass on a spring, and one that a damper alone ties to it.
    pub struct Behind { k: f64, c: f64, m: f64, n: f64 }
    free -> mass 1 { mass: n } -> damper 2 { damping: c } -> mass 3 { mass: m } -> spring 4 { stiffness: k } -> fixed;
}

/// Closed form: at rest the damper carries nothing, and the spring holds the mass.
#[test]
fn beside_what_only_a_damper_holds() {
    let system = Behind { k: 4.0, c: 3.0, m: 1.0, n: 2.0 }.build().unwrap();
    let (held, loose) = (Behind::mass_3.output(), Behind::mass_1.output());
    let at = |load, entry| system.frequency_response(load, entry).unwrap().at(Complex::new(0.0, 0.0));
    let value = at(held.force(), held.deflection()).unwrap();
    assert!((value - 0.25).norm() <= 8.0 * f64::EPSILON * 0.25, "{value}");
    assert_eq!(at(loose.force(), loose.deflection()), Err(MotionError::Resonance { frequency: 0.0 }));
}

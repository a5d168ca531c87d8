//! The models of tests/data/answers.json, whose values are those of independent fields with 40 digits.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use mstmm::Complex;
use mstmm::prelude::*;
use serde_json::Value;

system! {
    /// A beam with a mass and a spring at its tip.
    #[derive(Clone, Copy)]
    pub(crate) struct Cantilever {}
    fixed -> beam 1 { length: 1.2, bending_stiffness: 180.0, mass_per_length: 2.5 } -> point_mass 2 { mass: 0.8, inertia: 0.0 } -> conn tip -> free;
    fixed -> spring 3 { stiffness: 350.0 } -> conn tip;
}

system! {
    /// A portal frame with a mass at a corner.
    #[derive(Clone, Copy)]
    pub(crate) struct Portal {}
    section steel { axial_stiffness: 4e8, bending_stiffness: 1e6, mass_per_length: 20.0 }
    conn a at (0.0, 0.0) -> beam 1 { ..steel } -> conn b at (0.0, 3.0) -> beam 2 { ..steel } -> conn c at (4.0, 3.0) -> beam 3 { ..steel }
        -> conn d at (4.0, 0.0);
    fixed -> conn a;
    pinned -> conn d;
    conn b -> point_mass 4 { mass: 100.0 };
}

/// A part of the file.
pub(crate) fn reference(part: &str) -> Value {
    let file: Value = serde_json::from_str(include_str!("../data/answers.json")).unwrap();
    file[part].clone()
}

/// A number of the file, which stands there as text.
pub(crate) fn number(value: &Value) -> f64 {
    value.as_str().map_or_else(|| value.as_f64().unwrap(), |text| text.parse().unwrap())
}

#[track_caller]
pub(crate) fn assert_close(found: impl Into<Complex<f64>>, expected: impl Into<Complex<f64>>, tolerance: f64) {
    let (found, expected) = (found.into(), expected.into());
    let error = (found - expected).norm() / expected.norm();
    assert!(error <= tolerance, "{found} instead of {expected}: {error:e}");
}

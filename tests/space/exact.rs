//! The frequencies, shapes and receptances of tests/data/space.json.
#![expect(clippy::unwrap_used, reason = "a file that is not as it should be fails the test")]

use crate::cases::cases;
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;

/// Rounding of a frequency beside its condition, in units of 2^-52.
const ROUNDINGS: f64 = 4.0;

/// Oracle: dynamic stiffness in 77 digits with counts in ball arithmetic, checked by polynomials.
#[test]
fn all_frequencies_are_proven_and_exact() {
    let mut compared = 0;
    for case in cases().into_iter().filter(|case| case.wanted["lambda"].is_null()) {
        let structure = case.frame.build().unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let exact = case.frequencies();
        let count = case.wanted["omega"].as_array().unwrap().len();
        let found = structure.frequencies(count).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        for exact in exact.iter().filter(|exact| exact.mode <= count as u64) {
            // roots that rounding tells apart may be one entry, and one root is never two
            let last = exact.mode + exact.multiplicity - 1;
            let holds = |own: &&NaturalFrequency<f64>| own.index <= exact.mode && last < own.index + own.multiplicity;
            let own = found.iter().find(holds).unwrap_or_else(|| panic!("{} {}", case.name, exact.mode));
            let error = (DoubleDouble::from(own.omega) - exact.omega).to_f64().abs();
            let limit = exact
                .condition
                .map_or(1e-3, |condition| ROUNDINGS * f64::EPSILON * condition.max(1.0) * exact.omega.to_f64());
            assert!(error <= limit && own.is_proven, "{} {}: {error:e} of {limit:e}, {own:?}", case.name, exact.mode);
            compared += 1;
        }
    }
    assert!(compared >= 150, "{compared}");
}

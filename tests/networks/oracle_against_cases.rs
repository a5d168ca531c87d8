//! The oracle against the exact frequencies of tests/data/frames.json.

use crate::oracle::Oracle;
use crate::reference_cases::reference_cases;
use mstmm::number::DoubleDouble;

/// Part of a frequency within which its count changes: a hundred times the rounding of 24 digits.
pub(crate) const SHARP: f64 = 1e-22;

/// Oracle: global dynamic stiffness in 77 digits, by others.
#[test]
fn counts_change_at_the_exact_frequencies() {
    for case in reference_cases() {
        let oracle = Oracle::of(&case.structure);
        for exact in case.frequencies {
            let below = exact.mode - 1;
            let is_zero = exact.omega == DoubleDouble::from(0.0);
            let (lower, upper) = if is_zero {
                (None, DoubleDouble::from(1e-6))
            } else {
                let [lower, upper] = [-SHARP, SHARP].map(|part| exact.omega * DoubleDouble::from_sum(1.0, part));
                (Some(lower), upper)
            };
            if let Some(lower) = lower {
                assert_eq!(oracle.count_below(lower), Some(below), "{}: below {}", case.name, exact.omega);
            }
            assert_eq!(
                oracle.count_below(upper),
                Some(below + exact.multiplicity),
                "{}: above {}",
                case.name,
                exact.omega
            );
        }
    }
}

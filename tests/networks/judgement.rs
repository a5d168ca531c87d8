//! What a search for natural frequencies must say of structures: any search, given as a function.
#![expect(clippy::panic, reason = "a search that fails where it may not fails the test that called it")]

use crate::checks::{Found, check_frequencies};
use crate::families::Named;
use crate::oracle::Oracle;
use crate::reference_cases::{ExactFrequency, ReferenceCase, reference_cases};
use crate::structure::Structure;
use mstmm::number::{DoubleDouble, Parameter};

/// Relative width of an interval per unit of the frequency's condition: 36 eps.
const WIDTH: f64 = 8e-15;

/// Part of a frequency within which counts in `f64` change.
const BESIDE: f64 = 1e-13;

/// What was compared over many structures.
#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) structures: usize,
    /// Frequencies or counts.
    pub(crate) entries: usize,
    /// Counts of which the oracle cannot tell.
    pub(crate) unsure: usize,
    /// Names of structures that were refused, and why.
    pub(crate) refusals: Vec<(String, String)>,
}

/// The exact frequencies of tests/data/frames.json lie in the intervals that a search finds, as often as they are there, and
/// the intervals are no wider than their condition asks for.
///
/// The search returns the first frequencies of a case.
pub(crate) fn judge_reference_cases(search: impl Fn(&ReferenceCase) -> Result<Vec<Found>, String>) {
    for case in reference_cases() {
        let found = search(&case).unwrap_or_else(|error| panic!("{}: {error}", case.name));
        judge_frequencies(case.name, &found, &case.frequencies);
        check_frequencies(&case.structure, &found);
    }
}

/// The same of the first frequencies of one case.
pub(crate) fn judge_frequencies(name: &str, found: &[Found], exact: &[ExactFrequency]) {
    assert!(found.len() > 1, "{name}: {found:?}");
    let mut before = 0;
    for (found, exact) in found.iter().zip(exact) {
        if exact.mode != before + 1 {
            // the file goes on with single modes far above
            break;
        }
        before += exact.multiplicity;
        if let Err(message) = compared(found, exact) {
            panic!("{name}: {message}: {found:?}, {exact:?}");
        }
    }
}

fn compared(found: &Found, exact: &ExactFrequency) -> Result<(), &'static str> {
    let [lower, upper] = [found.lower, found.upper].map(DoubleDouble::from);
    if found.multiplicity != exact.multiplicity {
        return Err("another multiplicity");
    }
    if !(lower <= exact.omega && exact.omega <= upper) {
        return Err("outside of the interval");
    }
    let is_wide = |condition: f64| (upper - lower).to_f64() > WIDTH * condition * exact.omega.to_f64();
    if exact.condition.is_some_and(is_wide) { Err("a wide interval") } else { Ok(()) }
}

/// Counts just below and just above the exact frequencies, those of single modes far above as well.
pub(crate) fn judge_reference_counts(count: impl Fn(&Structure, f64) -> Result<u64, String>) {
    for case in reference_cases() {
        for exact in &case.frequencies {
            let (omega, below) = (exact.omega.to_f64(), exact.mode - 1);
            let expected = [(1.0 - BESIDE, below), (1.0 + BESIDE, below + exact.multiplicity)];
            for (part, expected) in expected.into_iter().filter(|_| omega > 0.0) {
                let found = count(&case.structure, omega * part);
                assert_eq!(found, Ok(expected), "{}: below {part} of mode {}", case.name, exact.mode);
            }
        }
    }
}

/// The first frequencies that a search finds of structures are where they belong.
pub(crate) fn judge_searches(
    structures: impl Iterator<Item = Named>,
    search: impl Fn(&Structure) -> Result<Vec<Found>, String>,
) -> Tally {
    let mut tally = Tally::default();
    for (name, structure) in structures {
        tally.structures += 1;
        match search(&structure) {
            Err(error) => tally.refusals.push((name, error)),
            Ok(found) => {
                tally.entries += found.len();
                tally.unsure += check_frequencies(&structure, &found);
            }
        }
    }
    tally
}

/// The counts of structures below frequencies of all sizes are those of the oracle.
pub(crate) fn judge_counts(
    structures: impl Iterator<Item = Named>,
    omegas: &[f64],
    count: impl Fn(&Structure, f64) -> Result<u64, String>,
) -> Tally {
    let mut tally = Tally::default();
    for (name, structure) in structures {
        tally.structures += 1;
        let oracle = Oracle::of(&structure);
        for &omega in omegas {
            match (count(&structure, omega), oracle.count_below(DoubleDouble::from(omega))) {
                (Err(error), _) => tally.refusals.push((name.clone(), error)),
                (_, None) => tally.unsure += 1,
                (Ok(count), Some(exact)) => {
                    assert_eq!(count, exact, "{name} below {omega:e}\n{structure:?}");
                    tally.entries += 1;
                }
            }
        }
    }
    tally
}

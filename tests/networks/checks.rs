//! Whether frequencies are those of a structure, by counts of the oracle.

#![expect(clippy::panic, reason = "a failing check fails the test that called it")]

use crate::oracle::Oracle;
use crate::structure::Structure;
use mstmm::number::DoubleDouble;

/// A frequency that was found, and the interval that is said to hold it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) omega: f64,
    pub(crate) lower: f64,
    pub(crate) upper: f64,
    pub(crate) multiplicity: u64,
}

/// Asserts that the first frequencies of a structure are in their intervals, none missing: the count at the lower end of
/// each is the number of those before, at the upper end that with its multiplicity.
///
/// Returns the number of ends at which the matrix cannot tell. An end at zero says nothing.
pub(crate) fn check_frequencies(structure: &Structure, found: &[Found]) -> usize {
    match wrong_count(&Oracle::of(structure), 0, found) {
        Ok(unsure) => unsure,
        Err(message) => panic!("{message}\n{structure:?}"),
    }
}

/// The number of ends at which the matrix cannot tell; or the first count that is not what a list says, in words.
///
/// A list that starts at a frequency has so many others `below` it.
pub(crate) fn wrong_count(oracle: &Oracle, below: u64, found: &[Found]) -> Result<usize, String> {
    let (mut before, mut unsure) = (below, 0);
    for entry in found {
        let Found { omega, lower, upper, multiplicity } = *entry;
        if !(lower <= omega && omega <= upper) {
            return Err(format!("{entry:?} is not within its own interval"));
        }
        for (end, expected) in [(lower, before), (upper, before + multiplicity)] {
            match if end == 0.0 { Some(expected) } else { oracle.count_below(DoubleDouble::from(end)) } {
                None => unsure += 1,
                Some(count) if count != expected => {
                    return Err(format!("{count} below {end:e}, not {expected}: {entry:?}"));
                }
                Some(_) => {}
            }
        }
        before += multiplicity;
    }
    Ok(unsure)
}

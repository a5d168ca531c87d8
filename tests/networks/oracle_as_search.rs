//! The oracle's own bisection as a search: what judges searches lets a right one pass and no wrong one.

use crate::checks::{Found, wrong_count};
use crate::families::named::portal;
use crate::families::random::Spread;
use crate::families::{named_structures, random_structures};
use crate::judgement::{judge_counts, judge_reference_cases, judge_reference_counts, judge_searches};
use crate::oracle::Oracle;
use crate::structure::Structure;
use mstmm::number::{DoubleDouble, Parameter};

/// Relative distance of the ends of an interval from its middle.
const HALF_WIDTH: f64 = 4e-16;

/// The first frequencies, those of one `f64` together.
fn first(structure: &Structure, number: u64) -> Vec<Found> {
    let oracle = Oracle::of(structure);
    let mut found: Vec<Found> = Vec::new();
    for n in 1..=number {
        let omega = oracle.frequency(n).to_f64();
        match found.last_mut() {
            Some(last) if omega <= last.upper => last.multiplicity += 1,
            _ => {
                let [lower, upper] = [-HALF_WIDTH, HALF_WIDTH].map(|part| omega * (1.0 + part));
                found.push(Found { omega, lower, upper, multiplicity: 1 });
            }
        }
    }
    // the last may have others beside it
    if number > 1 {
        found.pop();
    }
    found
}

#[test]
fn bisection_finds_the_reference_frequencies() {
    judge_reference_cases(|case| Ok(first(&case.structure, 7)));
}

#[test]
fn bisection_finds_what_the_counts_say() {
    let small = named_structures().into_iter().filter(|(_, structure)| structure.members.len() < 9);
    let random = [Spread::Moderate, Spread::Stiff].map(|spread| random_structures(0..6, spread));
    let tally = judge_searches(small.chain(random.into_iter().flatten()), |structure| Ok(first(structure, 4)));
    assert!(tally.entries > 60 && tally.unsure == 0 && tally.refusals.is_empty(), "{tally:?}");
}

#[test]
fn counts_are_compared() {
    let count = |structure: &Structure, omega: f64| {
        Oracle::of(structure).count_below(DoubleDouble::from(omega)).ok_or("unsure".to_owned())
    };
    judge_reference_counts(count);
    let tally = judge_counts(random_structures(0..5, Spread::Moderate), &[0.1, 3.0, 40.0], count);
    assert_eq!([tally.structures, tally.entries, tally.unsure, tally.refusals.len()], [5, 15, 0, 0], "{tally:?}");
}

#[test]
fn a_list_with_a_gap_or_a_wrong_multiplicity_does_not_pass() {
    let structure = &portal(1e4, 1.0);
    let oracle = Oracle::of(structure);
    let found = first(structure, 5);
    assert_eq!(wrong_count(&oracle, 0, &found), Ok(0));
    assert_eq!(wrong_count(&oracle, 1, &found[1..]), Ok(0));
    assert!(wrong_count(&oracle, 0, &found[1..]).is_err());
    assert!(wrong_count(&oracle, 0, &[&found[..1], &found[2..]].concat()).is_err());
    assert!(wrong_count(&oracle, 0, &[Found { multiplicity: 2, ..found[0] }]).is_err());
    let aside = |part: f64| [Found { lower: found[0].omega * part, upper: 2.0 * found[0].omega, ..found[0] }];
    assert!(wrong_count(&oracle, 0, &aside(1.0 + 1e-15)).is_err());
}

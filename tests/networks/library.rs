//! The library against the independent count: exact reference cases, structures that are hard, random ones.

use crate::directed::Report;
use crate::families::random::Spread;
use crate::families::{named_structures, random_structures};
use crate::judgement::{Tally, judge_counts, judge_reference_cases, judge_reference_counts, judge_searches};
use crate::through_library::{count, first};

/// Frequencies of all sizes.
const OMEGAS: [f64; 8] = [1e-3, 0.11, 1.3, 7.7, 31.0, 170.0, 1900.0, 40_000.0];

fn show(name: &str, tally: &Tally) {
    println!("{name}: {} structures, {} entries, {} unsure", tally.structures, tally.entries, tally.unsure);
    for (name, why) in &tally.refusals {
        println!("  refused {name}: {why}");
    }
}

#[test]
fn exact_reference_cases_lie_in_their_intervals() {
    judge_reference_cases(|case| first(&case.structure));
}

#[test]
fn counts_beside_exact_frequencies_are_right() {
    judge_reference_counts(count);
}

#[test]
fn first_frequencies_of_hard_structures_are_where_they_belong() {
    let tally = judge_searches(named_structures().into_iter(), first);
    show("named", &tally);
    assert!(tally.refusals.is_empty());
}

#[test]
fn counts_of_hard_structures_are_right() {
    let tally = judge_counts(named_structures().into_iter(), &OMEGAS, count);
    show("named", &tally);
    assert!(tally.refusals.is_empty());
}

#[test]
fn random_structures_have_their_frequencies_where_they_belong() {
    for spread in [Spread::Moderate, Spread::Stiff] {
        show(&format!("{spread:?}"), &judge_searches(random_structures(0..30, spread), first));
    }
}

#[test]
fn counts_of_random_structures_are_right() {
    for spread in [Spread::Moderate, Spread::Stiff] {
        show(&format!("{spread:?}"), &judge_counts(random_structures(0..30, spread), &OMEGAS, count));
    }
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn thousands_of_random_structures_have_their_frequencies_where_they_belong() {
    for spread in [Spread::Moderate, Spread::Stiff] {
        let mut report = Report::default();
        random_structures(0..2000, spread).for_each(|structure| report.search(&structure));
        report.show(&format!("{spread:?}"));
        assert!(report.wrong.is_empty() && report.refused.len() * 500 < report.structures, "{spread:?}");
    }
}

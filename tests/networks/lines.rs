//! Structures in a line by stiffnesses, against the oracle.

use crate::directed::Report;
use crate::families::line::line_structures;
use crate::judgement::judge_counts;
use crate::through_library::count;

/// Frequencies of all sizes.
const OMEGAS: [f64; 6] = [1e-3, 0.31, 2.3, 17.0, 310.0, 9000.0];

fn judge(seeds: core::ops::Range<u64>) {
    let mut report = Report::default();
    line_structures(seeds.clone()).for_each(|structure| report.search(&structure));
    report.show("lines");
    report.shares.all_proven("lines");
    let tally = judge_counts(line_structures(seeds), &OMEGAS, count);
    println!("  {} counts, {} unsure, {} refused", tally.entries, tally.unsure, tally.refusals.len());
    assert!(report.wrong.is_empty() && report.refused.is_empty(), "{:#?} {:#?}", report.wrong, report.refused);
}

#[test]
fn structures_in_a_line_have_their_frequencies_where_they_belong() {
    judge(0..20);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn many_structures_in_a_line_have_their_frequencies_where_they_belong() {
    judge(0..2000);
}

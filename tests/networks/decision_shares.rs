//! How many frequencies of structures are proven between neighbouring numbers, and how many need more: cases with exact values, random
//! structures. Other families print their rows where they are judged.

use crate::checks::Found;
use crate::directed::Report;
use crate::families::random::Spread;
use crate::families::random_structures;
use crate::judgement::judge_frequencies;
use crate::reference_cases::{ExactFrequency, exact_frequencies, reference_cases};
use crate::sketches::frames::StringAndRod;
use crate::support::shares::Shares;
use crate::through_library::{asked, entries, first_list};
use mstmm::number::{DoubleDouble, Parameter};
use mstmm::prelude::*;
use mstmm::search::{FrequencyList, SearchError};

type List<const N: usize> = Result<FrequencyList<f64, N>, SearchError>;

/// Adds a list, and returns its entries.
fn told<const N: usize>(shares: &mut Shares, name: &str, found: Result<List<N>, String>) -> Vec<Found> {
    let found = found.unwrap_or_else(|error| unreachable!("{name}: {error}"));
    shares.search(&found, &|| name.to_owned());
    entries(&found.unwrap_or_else(|error| unreachable!("{name}: {error}")))
}

/// A single frequency of the file, compared in all its digits.
fn holds(found: &[Found], exact: &ExactFrequency) -> bool {
    let holds = |root: &Found| {
        let [lower, upper] = [root.lower, root.upper].map(DoubleDouble::from);
        lower <= exact.omega && exact.omega <= upper && root.multiplicity == exact.multiplicity
    };
    found.iter().any(holds)
}

/// The undamped plane structures of frames.json, to their 24 digits: the first frequencies, and those far above.
#[test]
fn decision_shares_of_exact_structures() {
    Shares::head("exact structures");
    let mut shares = Shares::default();
    for case in reference_cases() {
        let found = told(&mut shares, case.name, first_list(&case.structure));
        judge_frequencies(case.name, &found, &case.frequencies);
        for exact in case.frequencies.iter().filter(|exact| exact.omega > DoubleDouble::from(0.0)) {
            let near = exact.omega.to_f64();
            let beside = near * (1.0 - 1e-9)..=near * (1.0 + 1e-9);
            let list = asked(&case.structure, |network| Ok(network.natural_frequencies::<8>(beside)));
            assert!(holds(&told(&mut shares, case.name, list), exact), "{}, {exact:?}", case.name);
        }
    }
    let model = StringAndRod { left: 0.8, right: 1.2, tension: 100.0, ea: 1e4, m: 0.01, mass: 0.02 };
    let list = model.build().map(|system| system.first_frequencies::<10>()).map_err(|error| error.to_string());
    let found = told(&mut shares, "string_and_rod", list);
    judge_frequencies("string_and_rod", &found, &exact_frequencies("string_and_rod"));
    shares.show("frames.json");
    shares.all_proven("frames.json");
    assert_eq!(shares.widths[0], shares.entries, "{shares:?}");
}

/// A property: of parameters in 1e±4 none is refused, and all are proven.
fn random_ones(structures: u64) {
    Shares::head("random structures");
    for spread in [Spread::Moderate, Spread::Wide] {
        let mut report = Report::default();
        random_structures(10_000..10_000 + structures, spread).for_each(|structure| report.search(&structure));
        report.show(&format!("{spread:?}"));
        assert!(report.wrong.is_empty(), "{:#?}", report.wrong);
        report.shares.all_proven("random structures");
        assert_eq!(report.refused, Vec::<String>::new());
    }
}

#[test]
fn decision_shares_of_some_random_structures() {
    random_ones(30);
}

#[test]
#[ignore = "many structures: in .ci/long"]
fn decision_shares() {
    random_ones(4000);
}

//! Large structures: their first frequencies and some of the thousandth.

use crate::checks::Found;
use crate::directed::Report;
use crate::families::Named;
use crate::families::directed::{free_ladder, free_storeys};
use crate::families::line::line_structure;
use crate::families::named::{ladder, ring, star, storeys, zigzag};
use crate::families::random::{Spread, random_structure};
use crate::structure::Structure;
use crate::through_library::{asked, count, first_by, in_range, width};
use mstmm::prelude::*;
use std::time::Instant;

fn named(name: &str, structure: Structure) -> Named {
    (name.to_owned(), structure)
}

fn large() -> Vec<Named> {
    vec![
        named("zigzag(1000)", zigzag(1000)),
        named("zigzag(200)", zigzag(200)),
        named("ladder(40)", ladder(40, 1.0)),
        named("ladder(40, 1e6)", ladder(40, 1e6)),
        named("ladder(40, 1e-6)", ladder(40, 1e-6)),
        named("storeys(10, 3)", storeys(10, 3)),
        named("storeys(20, 1)", storeys(20, 1)),
        named("star(1e4)", star(1e4)),
        named("ring(48)", ring(48)),
        named("free_ladder(40)", free_ladder(40, 1.0)),
        named("free_storeys(6, 3)", free_storeys(6, 3, 1.0)),
    ]
}

/// A range of few frequencies around the n-th, and the number below.
pub(crate) fn around(structure: &Structure, n: u64) -> Result<([f64; 2], u64), String> {
    let (mut lower, mut upper) = (1e-3, 1e9);
    let (mut below, mut above) = (count(structure, lower)?, count(structure, upper)?);
    while above - below > 12 {
        let middle = f64::sqrt(lower * upper);
        let here = count(structure, middle)?;
        if here + 4 < n {
            (lower, below) = (middle, here)
        } else {
            (upper, above) = (middle, here)
        }
        if upper / lower < 1.0 + 1e-9 {
            break;
        }
    }
    Ok(([lower, upper], below))
}

/// The frequencies around the n-th.
fn mode(structure: &Structure, n: u64) -> Result<(Vec<Found>, u64, usize), String> {
    let ([lower, upper], below) = around(structure, n)?;
    let (found, evaluations) = in_range(structure, lower..=upper)?;
    // one at the lower end may be below
    let found: Vec<Found> = found.into_iter().filter(|root| root.lower > lower && root.upper < upper).collect();
    Ok((found, below, evaluations))
}

fn judge_large(structures: Vec<Named>, modes: &[u64]) {
    let (mut wrong, mut refused) = (Vec::new(), Vec::new());
    for (name, structure) in structures {
        let mut report = Report::default();
        let start = Instant::now();
        let mut evaluations = 0;
        match first_by(&structure) {
            Ok((found, took)) => {
                evaluations = took;
                if name.starts_with("free") || name.starts_with("ring") {
                    assert!(found[0].omega == 0.0 && found[0].multiplicity == 3 && found[1].omega > 0.0, "{name}");
                }
                let time = start.elapsed();
                println!("{name}: width {:?}, {evaluations} evaluations, {time:?}", width(&structure));
                report.compare(&name, &structure, 0, &found);
            }
            Err(error) => report.refused.push(format!("{name}, first: {error}")),
        }
        for &n in modes {
            match mode(&structure, n) {
                Ok((found, below, took)) => {
                    println!("  mode {n}: {} in range, {took} evaluations", found.len());
                    report.compare(&format!("{name}, {n}"), &structure, below, &found);
                }
                Err(error) => report.refused.push(format!("{name}, mode {n}: {error}")),
            }
        }
        report.show(&name);
        println!("  {evaluations} evaluations of the first, oracle included {:?}", start.elapsed());
        wrong.extend(report.wrong);
        refused.extend(report.refused);
    }
    assert!(wrong.is_empty() && refused.is_empty(), "{wrong:#?} {refused:#?}");
}

#[test]
fn a_free_ladder_and_a_ring_have_their_frequencies_where_they_belong() {
    judge_large(vec![named("free_ladder(6)", free_ladder(6, 1.0)), named("ring(12)", ring(12))], &[]);
}

#[test]
#[ignore = "large: in .ci/long"]
fn large_structures_have_their_frequencies_where_they_belong() {
    judge_large(large(), &[1000]);
}

#[test]
#[ignore = "large: in .ci/long"]
fn the_first_three_hundred_frequencies_are_where_they_belong() {
    let random = |spread| (0..6).map(move |seed| (format!("{spread:?} {seed}"), random_structure(seed, spread)));
    let lines = (0..10).map(|seed| (format!("line {seed}"), line_structure(seed)));
    let mut report = Report::default();
    for (name, structure) in random(Spread::Moderate).chain(random(Spread::Stiff)).chain(lines) {
        let bound = around(&structure, 300);
        match bound.and_then(|([_, upper], _)| in_range(&structure, 0.0..=upper)) {
            Ok((found, evaluations)) => {
                println!("{name}: {} entries, {evaluations} evaluations", found.len());
                report.compare(&name, &structure, 0, &found[..found.len() - 1]);
            }
            Err(error) => report.refused.push(format!("{name}: {error}")),
        }
    }
    report.show("modes 1 to 300");
    assert!(report.wrong.is_empty(), "{:#?}", report.wrong);
}

#[test]
fn widths_do_not_grow_with_the_length_of_a_structure() {
    let storeys = [4, 10, 20].map(|levels| [1, 2, 3].map(|bays| width(&storeys(levels, bays))));
    assert!(storeys[1] == storeys[0] && storeys[2] == storeys[0], "{storeys:?}");
    let widths = [5, 40, 300].map(|length| [zigzag(length), ladder(length, 1.0), ring(length)].map(|s| width(&s)));
    println!("storeys of 1, 2, 3 bays: {:?}; zigzag, ladder, ring: {:?}", storeys[0], widths[0]);
    assert!(widths[1] == widths[0] && widths[2] == widths[0], "{widths:?}");
}

#[test]
#[ignore = "prints times: in .ci/long"]
fn time_per_member_does_not_grow_with_their_number() {
    for members in [10, 100, 1000] {
        let structure = zigzag(members);
        let start = Instant::now();
        let counts = 200;
        let asked = asked(&structure, |network| {
            let count = |k| network.count_below(0.1 + f64::from(k)).map_err(|error| error.to_string());
            (0..counts).map(count).sum::<Result<u64, String>>()
        });
        let time = start.elapsed() / counts / members as u32;
        assert!(asked.is_ok(), "{asked:?}");
        let evaluations = first_by(&structure).map(|(_, evaluations)| evaluations);
        println!("{members} members: {time:?} per member and count, {evaluations:?} evaluations for ten frequencies");
    }
}

//! Columns from half their critical load up to one part in 1e14 below it: intervals of their first frequencies, counts on both sides of each.

use super::exact::{double, fault_of_squares, pi, square};
use super::in_full;
use crate::general_chains::chain::{Chain, Link};
use crate::general_chains::families::PLAIN;
use crate::oracles::many_digits::exact;
use crate::oracles::short_pieces::roots_below;
use crate::support::random_tree::Random;
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;
use mstmm::list::StepList;
use mstmm::prelude::*;
use mstmm::search::{SearchError, System, Undamped};
use std::fmt::Debug;

const BITS: usize = 320;

/// Parts of a frequency on both sides of it.
const AWAY: [f64; 13] = [1e-15, 3e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3];

/// What was asked of a row of columns.
#[derive(Default)]
struct Row {
    models: usize,
    entries: usize,
    counts: usize,
    unproven: usize,
}

impl Row {
    /// That counts beside the first frequencies are right or not proven, which are known by their intervals.
    fn counts_beside<Y>(&mut self, system: &Y, found: &[NaturalFrequency], model: &dyn Debug)
    where
        Y: System<Parameter = f64> + Undamped + ?Sized,
    {
        self.models += 1;
        self.entries += found.len();
        let first_beyond = |at: f64| found.iter().find(|root| at < root.upper);
        for root in found {
            for at in AWAY.into_iter().flat_map(|away| [root.omega * (1.0 - away), root.omega * (1.0 + away)]) {
                // within an interval, or beyond all
                let Some(next) = first_beyond(at).filter(|next| at <= next.lower) else { continue };
                self.counts += 1;
                match system.count_below(at) {
                    Ok(count) => assert_eq!(count, next.index - 1, "{at} {model:?} {found:?}"),
                    Err(SearchError::Unproven { at_least, at_most, .. }) => {
                        assert!(at_least < next.index && next.index - 1 <= at_most, "{at} {model:?} {found:?}");
                        self.unproven += 1;
                    }
                    Err(other) => unreachable!("{other}: {at} {model:?}"),
                }
            }
        }
    }

    fn show(&self, name: &str) {
        let Row { models, entries, counts, unproven } = self;
        println!("| {name} | {models} | {entries} | {counts} | {unproven} |");
        assert!(*unproven * 1000 <= *counts, "{name}: {unproven} of {counts}");
    }
}

/// Parts below a critical load: a half, then two a decade.
fn parts(random: &mut Random) -> Vec<f64> {
    let mut decade = |k: i32| 10_f64.powi(-k) * (1.0 + 8.0 * random.unit());
    [0.5].into_iter().chain((1..=14).map(&mut decade).filter(|part| *part < 0.9)).collect()
}

system! {
    struct Pinned { length: f64, force: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> pinned
}

system! {
    struct TwoSpans { length: f64, force: f64 }
    pinned -> beam 1 { length, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> conn 2
        -> beam 3 { length, bending_stiffness: 1.0, mass_per_length: 1.0, axial_force: -force } -> pinned;
    conn 2 <- pinned
}

/// Closed form: `ω² = κ² (κ² - P)` with `κ = nπ/l`, in two words; of two equal spans it is that of the first mode.
fn pinned_columns(models: usize) {
    let (mut pinned, mut spans) = (Row::default(), Row::default());
    let random = &mut Random(0xb3);
    for _ in 0..models {
        let length = 0.5 + 2.0 * random.unit();
        for part in parts(random) {
            let force = std::f64::consts::PI.powi(2) / (length * length) * (1.0 - part);
            let squares: Vec<_> = (1..=4)
                .map(|n| {
                    let wave = pi(n) * pi(n) / (double(length) * double(length));
                    wave * (wave - double(force))
                })
                .collect();
            let column = Pinned { length, force }.build().unwrap();
            let found = column.first_frequencies::<3>().unwrap();
            assert_eq!(fault_of_squares(&found, &squares), None, "{length} {force}");
            pinned.counts_beside(&column, &found, &(length, force));
            let column = TwoSpans { length, force }.build().unwrap();
            let found = column.first_frequencies::<3>().unwrap();
            assert_eq!(fault_of_squares(&found, &squares[..1]), None, "{length} {force}");
            spans.counts_beside(&column, &found, &(length, force));
        }
    }
    pinned.show("pinned columns");
    spans.show("two spans");
}

/// A number whose square is next to a critical one from below, by bisection of counts of many digits just below zero.
fn critical_force(chain: &dyn Fn(f64) -> Chain) -> f64 {
    // a force at which many digits do not decide it is not below
    let grows = |force: f64| roots_below(&chain(force), &-exact(1e-60, BITS)).is_none_or(|count| count > 0);
    let (mut lower, mut upper) = (0.0, 1.0);
    while !grows(upper) {
        (lower, upper) = (upper, 2.0 * upper);
    }
    for _ in 0..60 {
        let middle = 0.5 * (lower + upper);
        if grows(middle) { upper = middle } else { lower = middle }
    }
    lower
}

/// A kind of chain whose column is pressed by a force, from a length and a random number.
type Kind = (&'static str, fn(GeneralBeam<f64>, f64) -> Chain);

const KINDS: [Kind; 6] = [
    ("clamped columns", |column, _| chain(Support::Fixed, vec![Link::Beam(column)], Support::Fixed)),
    ("columns on a foundation, with shear", |column, number| {
        let other = GeneralBeam {
            shear_stiffness: 100.0 / number,
            rotary_inertia: 0.002,
            foundation_stiffness: 50.0 * number,
            ..column
        };
        chain(Support::Pinned, vec![Link::Beam(other)], Support::Pinned)
    }),
    ("cantilevers with a mass", |column, number| {
        let mass = Link::Mass { mass: 3.0 * number, inertia: 0.1 * number };
        chain(Support::Free, vec![mass, Link::Beam(column)], Support::Fixed)
    }),
    ("columns, then masses", |column, number| {
        let links = vec![Link::Beam(column), Link::Mass { mass: 10.0 * number, inertia: 0.0 }, Link::Beam(column)];
        chain(Support::Pinned, links, Support::Pinned)
    }),
    ("columns, then beams", |column, number| {
        let beam = GeneralBeam { length: number, ..PLAIN };
        chain(Support::Pinned, vec![Link::Beam(column), Link::Beam(beam)], Support::Pinned)
    }),
    ("columns, then springs", |column, number| {
        let links = vec![Link::Spring(20.0 * number), Link::Beam(column)];
        chain(Support::Free, links, Support::Pinned)
    }),
];

fn chain(tip: Support, links: Vec<Link>, root: Support) -> Chain {
    Chain { tip, links, root }
}

/// Oracle: counts of many digits at both ends of each interval, and beside.
fn columns_of_all_kinds(models: usize) {
    for (seed, (name, kind)) in (0..).zip(KINDS) {
        let random = &mut Random(0xb30 + seed);
        let mut row = Row::default();
        for _ in 0..models {
            let (length, number) = (0.5 + 1.5 * random.unit(), 0.2 + random.unit());
            let pressed = |force: f64| kind(GeneralBeam { length, axial_force: -force, ..PLAIN }, number);
            let critical = critical_force(&pressed);
            for part in parts(random) {
                let chain = pressed(critical * (1.0 - part));
                let steps = chain.steps();
                let list = StepList::new(&steps).unwrap();
                let found = list.first_frequencies::<2>().unwrap();
                for root in &found {
                    let counts = [root.lower, root.upper].map(|end| {
                        let end = exact(end, BITS);
                        roots_below(&chain, &(&end * &end)).unwrap()
                    });
                    let holds = counts[0] < root.index && counts[1] >= root.index + root.multiplicity - 1;
                    assert!(holds && root.is_proven, "{name} {part} {counts:?} {root:?} {chain:?}");
                }
                row.counts_beside(&list, &found, &chain);
            }
        }
        row.show(name);
    }
}

/// Squares that a number cannot tell apart have frequencies that it can: the exact square of an end is one of two words.
#[test]
fn squares_of_ends_are_exact() {
    let end = 1.0 + f64::EPSILON;
    let (high, low) = square(end).parts();
    assert_eq!((high, low), (1.0 + 2.0 * f64::EPSILON, f64::EPSILON * f64::EPSILON));
}

in_full! {
    pinned_columns(2, 60) = some_pinned_columns, all_pinned_columns;
    columns_of_all_kinds(1, 10) = some_columns_of_all_kinds, all_columns_of_all_kinds;
}

//! Whole runs through models with each operation rounded to the wrong side: no bound is false.
//!
//! In two words all roundings are far below a unit in the last place of ω, so that a bound that forgets one is right all the same. In one
//! word they show.

use crate::proof::count::Side;
use crate::proof::level::Level;
use crate::proof::memory::{Memory, Question};
use crate::proof::number::OneWord;
use crate::proof::prover::Prover;
use crate::proof::tests::models::Model;
use crate::proof::tests::random::Random;
use crate::proof::tests::truth::Truth;
use crate::proof::tests::worst::{WAYS, Worst, choose};
use crate::proof::visit::Visited;
use std::vec::Vec;

/// Relative errors of inverses.
const OF_INVERSES: [f64; 3] = [0.0, 1e-13, -3e-12];

/// What was seen.
#[derive(Debug, Default)]
struct Seen {
    models: usize,
    bounds: usize,
    /// Bounds that are as sharp as can be.
    sharp: usize,
}

/// Frequencies beside those of a model, on both sides, from a unit in the last place on.
fn places(random: &mut Random, truth: &Truth) -> Vec<f64> {
    let mut all = Vec::new();
    for root in truth.roots.iter().filter(|root| root.omega > 0.0) {
        all.extend([root.lower, root.upper]);
        for decade in -16..-1 {
            let part = 10f64.powf(f64::from(decade) + random.unit());
            all.extend([root.lower * (1.0 - part), root.upper * (1.0 + part)]);
        }
    }
    all
}

/// Both bounds at a frequency against what is known of the count.
fn hold<N: Level<Word = f64>>(parts: &dyn Visited, omega: f64, truth: &Truth, seed: u64, seen: &mut Seen) {
    let [least, most] = truth.count(omega).map(|count| count as f64);
    for side in [Side::AtLeast, Side::AtMost] {
        let question = Question { model: parts, places: &[([omega, 0.0], side)], sign: 1.0 };
        let Ok([outcome, ..]) = Memory::default().run::<N>(question) else { continue };
        // a bound that was lost is NaN
        let is_false = if side == Side::AtLeast { outcome.count > most } else { outcome.count < least };
        assert!(!is_false, "seed {seed}, ω = {omega:e}, {side:?}: {} and not {least} to {most}", outcome.count);
        seen.bounds += 1;
        seen.sharp += usize::from(least == most && outcome.count == least);
    }
}

fn check(seeds: core::ops::Range<u64>, enough: usize) {
    let mut seen = Seen::default();
    for seed in seeds {
        let mut random = Random::new(seed ^ 0x77);
        let decades = 1.0 + random.below(3) as f64;
        let model = Model::new(&mut random, decades);
        let mut picked = Random::new(seed);
        model.ask(&mut random, |asked| {
            let Some(roots) = asked.frequencies() else { return };
            seen.models += 1;
            let parts = asked.parts();
            let truth = Truth::new(roots, &mut Prover::new(&*parts));
            for omega in places(&mut picked, &truth) {
                hold::<OneWord>(&*parts, omega, &truth, seed, &mut seen);
                for sums in WAYS {
                    for products in WAYS {
                        choose(sums, products, OF_INVERSES[picked.below(3)], seed);
                        hold::<Worst>(&*parts, omega, &truth, seed, &mut seen);
                    }
                }
            }
        });
        if seen.models >= enough {
            break;
        }
    }
    std::println!("{seen:#?}");
    assert!(seen.models >= enough, "too few models");
    assert!(5 * seen.sharp > seen.bounds, "bounds are too weak for a test");
}

#[test]
fn no_bound_of_a_run_is_false_whatever_way_it_rounds() {
    check(0..20, 4);
}

#[test]
#[ignore = "long: .ci/long"]
fn no_bound_of_many_runs_is_false_whatever_way_they_round() {
    check(100..1_000, 200);
}

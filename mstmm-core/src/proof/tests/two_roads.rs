//! Bounds by two roads never cross: two words and four, and two orders of elimination of the same model.

use crate::proof::count::Side;
use crate::proof::prover::{Precision, Prover};
use crate::proof::tests::campaign::BESIDE;
use crate::proof::tests::models::{Asked, Model, SOUGHT};
use crate::proof::tests::random::Random;
use crate::proof::tests::truth::Truth;
use std::vec::Vec;

/// Frequencies at which each model is asked.
const PLACES: usize = 12;

/// Relative distance from a frequency at which Δ has its sign.
const APART: f64 = 1e-9;

/// Both bounds of one precision.
type Bounds = [Option<u64>; 2];

/// What was seen.
#[derive(Debug, Default)]
struct Seen {
    models: usize,
    frequencies: usize,
    /// Where both bounds meet, in two words and in four.
    met: [usize; 2],
    /// Frequencies that are alone and odd, and those of them at which Δ changes its sign.
    odd: usize,
    changed: usize,
    /// Models of which Δ changes its sign at no frequency.
    held_twice: usize,
    /// Where the count by minors is outside of the bounds, beside a frequency, where the minors have no more digits.
    outside: usize,
}

/// The bounds in two words and in four.
fn bounds(prover: &mut Prover<'_>, omega: f64, sign: f64) -> [Bounds; 2] {
    [Precision::Two, Precision::Four]
        .map(|precision| [Side::AtLeast, Side::AtMost].map(|side| prover.bound_at(omega, sign, side, precision).count))
}

/// Whether some bound from below is above some bound from above.
fn do_cross(all: &[Bounds]) -> bool {
    let least = all.iter().filter_map(|bounds| bounds[0]).max();
    let most = all.iter().filter_map(|bounds| bounds[1]).min();
    least.zip(most).is_some_and(|(least, most)| least > most)
}

/// Where a model is asked: in decades about its frequencies, and up to a thousand numbers from them.
fn places(random: &mut Random, truth: &Truth, count: usize) -> Vec<f64> {
    let positive: Vec<f64> = truth.roots.iter().map(|root| root.omega).filter(|omega| *omega > 0.0).collect();
    let (Some(first), Some(last)) = (positive.first(), positive.last()) else { return Vec::new() };
    let decades = (1e5 * last / first).log10();
    let place = |k: usize| {
        if k.is_multiple_of(2) {
            return 1e-3 * first * 10f64.powf(decades * random.unit());
        }
        let root = positive[random.below(positive.len())];
        let numbers = 1000f64.powf(random.unit()) as u64;
        let up = random.below(2) == 0;
        f64::from_bits(if up { root.to_bits() + numbers } else { root.to_bits() - numbers })
    };
    (0..count).map(place).collect()
}

/// How many frequencies that are known are alone and odd, and at how many of them Δ changes its sign in twice the digits.
fn changes(model: &dyn Asked, truth: &Truth) -> [usize; 2] {
    let mut counts = [0; 2];
    for root in truth.roots.iter().filter(|root| root.omega > 0.0 && root.multiplicity % 2 == 1) {
        let [lower, upper] = [root.lower * (1.0 - APART), root.upper * (1.0 + APART)];
        let [before, after] = [truth.count(lower), truth.count(upper)];
        let is_alone = before == [root.index - 1; 2] && after[0] == root.index + root.multiplicity - 1;
        if is_alone && (after[0] == after[1] || root.index as usize >= SOUGHT) {
            counts[0] += 1;
            counts[1] += usize::from(model.sign(lower) * model.sign(upper) < 0.0);
        }
    }
    counts
}

/// The bounds of a model in one order of elimination, its counts by minors, and at some places the bounds at the opposite of ω².
fn road(model: &dyn Asked, places: &[f64]) -> Vec<([Bounds; 2], Option<[Bounds; 2]>, u64)> {
    let parts = model.parts();
    let mut prover = Prover::new(&*parts);
    let at = |(k, omega): (usize, &f64)| {
        let opposite = (k % 8 < 2).then(|| bounds(&mut prover, *omega, -1.0));
        (bounds(&mut prover, *omega, 1.0), opposite, model.counted(*omega))
    };
    places.iter().enumerate().map(at).collect()
}

fn check(seeds: core::ops::Range<u64>, enough: usize) {
    let mut seen = Seen::default();
    for seed in seeds {
        let mut random = Random::new(seed ^ 0x0a5e);
        let decades = 1.0 + random.below(4) as f64;
        let model = Model::new(&mut random, decades);
        let mut picked = Random::new(seed);
        let one = model.ask(&mut random, |asked| {
            let roots = asked.frequencies()?;
            let parts = asked.parts();
            let truth = Truth::new(roots, &mut Prover::new(&*parts));
            let places = places(&mut picked, &truth, PLACES);
            let road = road(asked, &places);
            let [odd, changed] = changes(asked, &truth);
            // where something is held twice Δ vanishes at every frequency, and minors tell nothing
            let is_told = changed > 0;
            assert!(changed == odd || !is_told, "seed {seed}: Δ changes its sign at {changed} of {odd} frequencies");
            seen.held_twice += usize::from(!is_told);
            (seen.odd, seen.changed) = (seen.odd + odd, seen.changed + changed);
            Some((truth, places, road, is_told))
        });
        let Some((truth, places, one, is_told)) = one.flatten() else { continue };
        let Some(other) = model.ask(&mut random, |asked| road(asked, &places)) else { continue };
        seen.models += 1;
        for ((omega, one), other) in places.iter().zip(one).zip(other) {
            seen.frequencies += 1;
            let [least, most] = truth.count(*omega);
            let all = [one.0[0], one.0[1], other.0[0], other.0[1], [Some(least), Some(most)]];
            assert!(!do_cross(&all), "seed {seed}, ω = {omega:e}: {all:?}");
            if let (Some(one), Some(other)) = (one.1, other.1) {
                let below = [one[0], one[1], other[0], other[1], [Some(0), None]];
                assert!(!do_cross(&below), "seed {seed}, ω² = -({omega:e})²: {below:?}");
            }
            for precision in 0..2 {
                seen.met[precision] +=
                    usize::from(all[precision][0].is_some() && all[precision][0] == all[precision][1]);
            }
            let is_outside = [one.2, other.2].iter().any(|count| do_cross(&[all[0], all[1], [Some(*count); 2]]));
            if is_told && is_outside {
                let counted = [one.2, other.2];
                assert!(truth.is_beside(*omega, BESIDE), "seed {seed}, ω = {omega:e}: {all:?}, minors {counted:?}");
                seen.outside += 1;
            }
        }
        if seen.frequencies >= enough {
            break;
        }
    }
    std::println!("{seen:#?}");
    assert!(seen.frequencies >= enough, "too few frequencies");
    assert!(4 * seen.met[1] > 3 * seen.frequencies, "bounds are too weak for a test");
    assert!(100 * seen.outside <= seen.frequencies, "minors tell another count");
    assert!(20 * seen.held_twice <= seen.models, "too few models with a determinant");
}

#[test]
fn bounds_never_cross() {
    check(0..60, 240);
}

#[test]
#[ignore = "long: .ci/long"]
fn bounds_never_cross_at_a_hundred_thousand_frequencies() {
    check(1_000..20_000, 100_000);
}

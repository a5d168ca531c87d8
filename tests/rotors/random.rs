//! Random rotors: counts and critical speeds beside polynomial elements.
#![expect(clippy::panic, reason = "a rotor that is refused fails the test")]

use crate::numbers::Random;
use crate::polynomial_elements::Shafts;
use crate::shafts::{Between, Loose, Numbers, Overhung, Spools, Topology};
use mstmm::prelude::*;
use mstmm::search::critical_speeds;

/// What was compared.
#[derive(Debug, Default)]
struct Compared {
    counts: usize,
    /// The highest of them.
    highest: u64,
    critical: usize,
}

/// The stations of a rotor as a whirl sees them.
fn seen<M: Topology>(numbers: &Numbers, speed: f64, whirl: Whirl) -> Shafts {
    let shafts = M::shafts(numbers, speed);
    if whirl == Whirl::Forward { shafts } else { shafts.turned_round() }
}

/// Ten counts of a whirl at random frequencies and speeds.
fn counts<M: Topology>(random: &mut Random, compared: &mut Compared) {
    let numbers = Numbers::random(random);
    for _ in 0..10 {
        let whirl = if random.chance(0.5) { Whirl::Forward } else { Whirl::Backward };
        let (speed, omega) = (10f64.powf(2.5 * random.unit() - 1.0), 10f64.powf(3.5 * random.unit() - 1.0));
        let rotor = M::rotor(numbers, speed);
        let count = rotor
            .whirl(whirl)
            .count_below(omega)
            .unwrap_or_else(|error| panic!("{numbers:?} {speed} {omega}: {error}"));
        let expected = seen::<M>(&numbers, speed, whirl).count_below(omega, 0);
        assert_eq!(count, expected, "{numbers:?} at {speed}, {whirl:?} below {omega}");
        compared.counts += 1;
        compared.highest = compared.highest.max(count);
    }
}

/// The critical speeds of a range, of an order.
fn critical<M: Topology>(random: &mut Random, compared: &mut Compared) {
    let numbers = Numbers::random(random);
    let whirl = if random.chance(0.5) { Whirl::Forward } else { Whirl::Backward };
    let (order, end) = (random.pick([1.0, 1.0, 2.0, 0.5, 3.0]), 10f64.powf(1.0 + random.unit()));
    let build = |speed: f64| Ok(M::rotor(numbers, speed));
    let found = critical_speeds::<64, _>(0.0..=end, whirl, order, build);
    let found = found.unwrap_or_else(|error| panic!("{numbers:?} order {order}: {error}"));
    let below = |speed: f64| seen::<M>(&numbers, speed, whirl).count_below(order * speed, 0);
    let mut passed = 0;
    for critical in found.iter() {
        assert!(critical.is_proven && critical.index == passed + 1, "{numbers:?}: {critical:?}");
        assert!(critical.upper - critical.lower <= 16.0 * f64::EPSILON * critical.upper, "{critical:?}");
        // elements miss a root by less
        assert_eq!(below(critical.lower * (1.0 - 1e-11)), passed, "{numbers:?}: {critical:?}");
        passed += critical.multiplicity;
        assert_eq!(below(critical.upper * (1.0 + 1e-11)), passed, "{numbers:?}: {critical:?}");
        compared.critical += 1;
    }
    assert_eq!(below(end), passed, "{numbers:?}: {found:?}");
}

fn compare(rounds: usize) {
    let (mut random, mut compared) = (Random(37), Compared::default());
    for _ in 0..rounds {
        counts::<Between>(&mut random, &mut compared);
        counts::<Overhung>(&mut random, &mut compared);
        counts::<Loose>(&mut random, &mut compared);
        counts::<Spools>(&mut random, &mut compared);
        critical::<Between>(&mut random, &mut compared);
        critical::<Overhung>(&mut random, &mut compared);
        critical::<Spools>(&mut random, &mut compared);
    }
    println!("{} rotors: {compared:?}", 7 * rounds);
    assert!(compared.highest > 10 && compared.critical > 3 * rounds, "{compared:?}");
}

#[test]
fn counts_and_critical_speeds_are_those_of_polynomial_elements() {
    compare(4);
}

#[test]
#[ignore = "long: .ci/long"]
fn counts_and_critical_speeds_of_a_thousand_rotors() {
    compare(250);
}

//! False claims about random rotors: none is ever proven.
//!
//! Intervals of frequencies are moved off them, by one number or by far, and indices and multiplicities are off by one. Polynomial elements say what is false.
#![expect(clippy::panic, reason = "a false claim that is proven fails the test")]

use crate::numbers::Random;
use crate::polynomial_elements::Shafts;
use crate::shafts::{Between, Numbers, Overhung, Spools, Topology};
use mstmm::prelude::*;

/// Degrees beyond those of counts far from roots: a root of the elements is within 1e-20 of that of the rotor.
const MORE: usize = 16;

/// Half widths of claims, relative; zero is a number and the next one.
const HALF_WIDTHS: [f64; 6] = [0.0, 4.0 * f64::EPSILON, 16.0 * f64::EPSILON, 1e-12, 1e-9, 1e-5];

/// A claim: the frequencies from an index on, so many of them, are between two numbers.
#[derive(Clone, Copy, Debug)]
struct Claim {
    ends: [f64; 2],
    index: u64,
    multiplicity: u64,
}

impl Claim {
    /// Whether counts below both ends say so.
    fn holds(&self, counts: [u64; 2]) -> bool {
        counts[0] < self.index && counts[1] + 1 >= self.index + self.multiplicity
    }
}

/// What became of claims.
#[derive(Debug, Default)]
struct Tally {
    tried: usize,
    false_claims: usize,
    proven: usize,
}

/// Tries a claim.
fn try_claim<Y: Undamped<Parameter = f64>>(system: &Y, shafts: &Shafts, claim: Claim, tally: &mut Tally) {
    let [below, above] = claim.ends.map(|end| system.count_bounds(end));
    // what is proven: at most so many below the lower end, at least so many below the upper end
    let is_proven = claim.holds([below[1], above[0]]);
    let is_true = claim.holds(claim.ends.map(|end| shafts.count_below(end, MORE)));
    tally.tried += 1;
    tally.false_claims += usize::from(!is_true);
    tally.proven += usize::from(is_proven);
    if is_proven && !is_true {
        panic!("{claim:?} is false, and proven: {below:?} {above:?}, {shafts:?}");
    }
}

fn attack<M: Topology>(random: &mut Random, tally: &mut Tally) {
    let numbers = Numbers::random(random);
    let speed = 10f64.powf(2.5 * random.unit() - 1.0);
    let rotor = M::rotor(numbers, speed);
    let whirl = if random.chance(0.5) { Whirl::Forward } else { Whirl::Backward };
    let shafts = M::shafts(&numbers, speed);
    let shafts = if whirl == Whirl::Forward { shafts } else { shafts.turned_round() };
    let system = rotor.whirl(whirl);
    let roots = system.first_frequencies::<5>().unwrap_or_else(|error| panic!("{numbers:?} {speed}: {error}"));
    for root in roots.iter() {
        let (index, multiplicity) = (root.index, root.multiplicity);
        for half in HALF_WIDTHS {
            let next = |x: f64, steps: i64| f64::from_bits((x.to_bits() as i64 + steps) as u64);
            let width = if half > 0.0 { half * root.omega } else { 0.0 };
            let ends =
                if half > 0.0 { [root.omega - width, root.omega + width] } else { [root.omega, next(root.omega, 1)] };
            let shift = if half > 0.0 { 1.01 * width } else { 0.0 };
            let moved = [-1.0, 0.0, 1.0].map(|way| ends.map(|end| end + way * shift));
            let by_one = [-2, -1, 1, 2].map(|steps| ends.map(|end| next(end, steps)));
            for ends in moved.into_iter().chain(by_one) {
                try_claim(system, &shafts, Claim { ends, index, multiplicity }, tally);
            }
            for claim in [
                Claim { ends, index: index + 1, multiplicity },
                Claim { ends, index, multiplicity: multiplicity + 1 },
                Claim { ends, index: index.max(2) - 1, multiplicity },
            ] {
                try_claim(system, &shafts, claim, tally);
            }
        }
    }
}

fn campaign(rounds: usize) {
    let (mut random, mut tally) = (Random(3737), Tally::default());
    for _ in 0..rounds {
        attack::<Between>(&mut random, &mut tally);
        attack::<Overhung>(&mut random, &mut tally);
        attack::<Spools>(&mut random, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.false_claims > tally.tried / 4 && tally.proven > tally.tried / 5, "{tally:?}");
}

#[test]
fn no_false_claim_about_a_rotor_is_proven() {
    campaign(1);
}

#[test]
#[ignore = "long: .ci/long"]
fn many_false_claims_about_rotors_are_not_proven() {
    campaign(60);
}

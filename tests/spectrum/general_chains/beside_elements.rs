//! Counts of random chains beside those of finite elements of a high degree, at squares of frequencies of either sign.

use super::chain::{Chain, Link};
use super::families::{chains, decade};
use crate::oracles::many_digits::exact;
use crate::oracles::polynomial_beams::{longest, roots_of_elements};
use crate::support::random_tree::Random;
use mstmm::element::WittrickWilliams;
use mstmm::list::{AnyUndamped, StepList};
use mstmm::prelude::*;
use mstmm::search::{Characteristic, SearchError};

type List<'a> = StepList<'a, AnyUndamped<f64>>;

/// Wave numbers times lengths up to which elements are asked.
const LONGEST: f64 = 150.0;

/// Frequencies of each chain at which it is counted.
const COUNTS: usize = 3;

/// What was compared.
#[derive(Debug, Default)]
struct Compared {
    chains: usize,
    unstable: usize,
    /// Counts where the square is below zero, and above.
    counts: [usize; 2],
    highest: u64,
    misses: Vec<String>,
}

/// The number of roots by a pass at a frequency.
fn below(list: &List<'_>, omega: f64) -> u64 {
    let mut counter: WittrickWilliams = WittrickWilliams::default();
    let _ = list.pass(omega, &mut counter);
    counter.below()
}

/// A chain some of whose beams are pressed, up to far beyond their critical loads.
fn loaded(random: &mut Random) -> Chain {
    let mut chain = chains(random).chain;
    let share = random.pick([0.0, 0.3, 0.8]);
    for link in &mut chain.links {
        let (Link::Beam(beam) | Link::Side(_, beam)) = link else { continue };
        if random.chance(share) {
            let force = decade(random, 0.0, 2.5) * beam.bending_stiffness / (beam.length * beam.length);
            beam.axial_force =
                -if beam.shear_stiffness < f64::INFINITY { force.min(0.7 * beam.shear_stiffness) } else { force };
        }
    }
    chain
}

impl Compared {
    /// Compares a count with that of elements at a frequency, or just below zero.
    fn compare(&mut self, chain: &Chain, rate: f64, sign: f64, count: u64) {
        let square = exact(rate, 384) * exact(sign * rate, 384);
        let elements = roots_of_elements(chain, &square, 0);
        if elements != Some(count) {
            let more = roots_of_elements(chain, &square, 40);
            let text =
                format!("{count} below {sign} * {rate}², and not {elements:?}, of more degrees {more:?}: {chain:?}");
            self.misses.push(text);
        }
        self.counts[usize::from(sign > 0.0)] += 1;
        self.highest = self.highest.max(count);
    }

    fn judge(&mut self, chain: &Chain, random: &mut Random) {
        self.chains += 1;
        let steps = chain.steps();
        let list: List<'_> = StepList::new(&steps).unwrap();
        let growing = list.unstable_modes().unwrap();
        self.unstable += usize::from(growing > 0);
        self.compare(chain, 1e-30, -1.0, growing);
        let mut highest = 1e-2;
        while below(&list, highest) < growing + 12 && longest(chain, highest * highest) < LONGEST {
            highest *= 1.5;
        }
        for _ in 0..COUNTS {
            let omega = highest * random.unit();
            let count = below(&list, omega);
            self.compare(chain, omega, 1.0, count);
            // what searches say of it
            match list.count_below(omega) {
                Ok(searched) if growing == 0 && searched == count => {}
                Err(SearchError::Unstable { modes }) if growing > 0 && modes == growing => {}
                other => self.misses.push(format!("{other:?} of {count} below {omega}, {growing} grow: {chain:?}")),
            }
        }
    }

    fn of(seeds: core::ops::Range<u64>) -> Self {
        let mut compared = Compared::default();
        for seed in seeds {
            let random = &mut Random(seed.wrapping_mul(0x9e37) ^ 0xe1e);
            let chain = loaded(random);
            compared.judge(&chain, random);
        }
        let Compared { chains, unstable, counts, highest, misses } = &compared;
        println!(
            "{chains} chains, {unstable} unstable, counts below and above zero {counts:?}, up to {highest}, {} missed",
            misses.len()
        );
        for miss in misses.iter().take(3) {
            println!("   MISS {miss}");
        }
        compared
    }
}

/// Oracle: the inertia of `K - ω² M` of polynomials.
#[test]
fn counts_of_chains_are_those_of_elements() {
    let compared = Compared::of(0..50);
    assert_eq!(compared.misses, Vec::<String>::new());
    assert!(compared.unstable > 10 && compared.highest > 12, "{compared:?}");
}

#[test]
#[ignore = "long: .ci/long"]
fn counts_of_a_thousand_chains_are_those_of_elements() {
    let compared = Compared::of(50..1050);
    assert_eq!(compared.misses, Vec::<String>::new());
    assert!(compared.unstable > 200, "{compared:?}");
}

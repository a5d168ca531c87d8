//! Chains of general beams that are hard, beside counts of many digits.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

mod beside_elements;
pub(crate) mod chain;
pub(crate) mod families;
mod judge;

use crate::oracles::many_digits::exact;
use crate::oracles::short_pieces::roots_below;
use crate::support::random_tree::Random;
use chain::{Chain, Link};
use families::{FAMILIES, Family, PLAIN};
use judge::Tally;
use mstmm::element::Support;
use mstmm::elements::GeneralBeam;
use mstmm::list::StepList;
use mstmm::prelude::*;

fn run((name, family): Family, models: u64, heights: &[u64]) {
    let mut tally = Tally::default();
    for seed in 0..models {
        let random = &mut Random(seed.wrapping_mul(0x9e37) ^ 0x6e5);
        let named = family(random);
        let high = heights[random.below(heights.len())];
        tally.judge(&named.chain, high, &named.at, random);
    }
    tally.show(name);
    assert!(tally.misses.is_empty(), "{name}: {}", tally.misses[0]);
    // at a frequency itself a count is refused
    let refused = tally.refusals.keys().find(|kind| *kind != "count Unresolved");
    assert_eq!(refused, None, "{name}: {:?}", tally.refusals);
    assert!(models == 1 || tally.roots > 0);
}

#[test]
fn hard_chains_have_the_counts_of_many_digits() {
    for family in FAMILIES {
        run(family, 1, &[4]);
    }
}

#[test]
#[ignore = "long: .ci/long"]
fn many_hard_chains_have_the_counts_of_many_digits() {
    for family in FAMILIES {
        run(family, 30, &[10, 40, 120]);
    }
}

/// A load `10^-k` below the critical one, whose first root is a difference of numbers `10^k` times as large.
#[test]
fn a_column_beside_its_buckling_load_has_its_root_in_the_interval() {
    use Support::{Fixed, Free, Guided, Pinned};
    let square = std::f64::consts::PI.powi(2);
    // the square of the first root of tan z = z
    let propped = 20.190_728_556_426_63;
    let cases = [
        (Pinned, Pinned, square),
        (Fixed, Fixed, 4.0 * square),
        (Fixed, Free, 0.25 * square),
        (Fixed, Pinned, propped),
        (Pinned, Fixed, propped),
        (Guided, Pinned, 0.25 * square),
        (Guided, Fixed, square),
    ];
    for (tip, root, critical) in cases {
        for k in 1..15 {
            let axial_force = -critical * (1.0 - 10_f64.powi(-k));
            let beam = GeneralBeam { axial_force, ..PLAIN };
            let chain = Chain { tip, links: vec![Link::Beam(beam)], root };
            let steps = chain.steps();
            let found = StepList::new(&steps).unwrap().first_frequencies::<2>().unwrap();
            for (index, root) in (0..).zip(&found) {
                let below =
                    [root.lower, root.upper].map(|end| roots_below(&chain, &(exact(end, 320) * exact(end, 320))));
                assert_eq!(below, [Some(index), Some(index + 1)], "{tip:?} {k}: {root:?}");
            }
        }
    }
}

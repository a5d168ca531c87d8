//! Chains and branches with hinges of one freedom and levers, of any stiffness and length.

use super::parts::{beam, below, body, decimal, joint, root, tip};
use super::searches::{counts_up_to, first_eigenvalues, first_frequencies, frequencies_up_to};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::random_tree::Random;
use crate::support::tree::{Part, Tree};
use mstmm::element::Support;
use mstmm::elements::{Lever, RotationalHinge, ShearHinge};
use mstmm::list::ListStep;

/// Decades of the stiffness of hinges.
pub(crate) const STIFFNESS: i32 = 12;

/// Decades of the length of levers.
pub(crate) const LENGTH: i32 = 3;

/// A number with three digits, in so many decades below and above one.
fn extreme(random: &mut Random, decades: i32) -> f64 {
    let decade = below(random, 2 * decades as usize + 1) as i32 - decades;
    decimal(random, 1.0, 10.0) * 10f64.powi(decade)
}

/// A hinge, one of four without stiffness, or a lever in either direction.
fn single(random: &mut Random) -> ListStep<Part> {
    let stiffness = if random.chance(0.25) { 0.0 } else { extreme(random, STIFFNESS) };
    ListStep::Element(match random.below(4) {
        0 => Part::RotationalHinge(RotationalHinge { stiffness }),
        1 => Part::ShearHinge(ShearHinge { stiffness }),
        _ => Part::Lever(Lever { output_x: random.pick([-1.0, 1.0]) * extreme(random, LENGTH) }),
    })
}

/// A path of beams and bodies with a joint behind each, twice a lever there and back.
fn path(random: &mut Random) -> Tree {
    let support = random.pick([Support::Fixed, Support::Pinned, Support::Guided, Support::Free]);
    let mut tree = vec![tip(support)];
    for _ in 0..1 + random.below(3) {
        let mut number = |from, to| decimal(random, from, to);
        let (length, offset) = (number(0.5, 2.0), number(-1.0, 1.0));
        let heavy = body(number(0.2, 2.0), number(1.0, 2.0), offset, 0.5 * offset);
        let span = beam(length, number(0.5, 2.0), 1.0);
        tree.push(if random.chance(0.25) { heavy } else { span });
        let next = single(random);
        tree.push(next);
        if let ListStep::Element(Part::Lever(lever)) = next
            && random.chance(0.5)
        {
            tree.push(ListStep::Element(Part::Lever(Lever { output_x: -lever.output_x })));
        }
    }
    tree
}

/// A chain, or two paths that meet.
pub(crate) fn tree(seed: u64) -> Tree {
    let random = &mut Random(seed ^ 0x6a0);
    let first = path(random);
    let last = beam(decimal(random, 0.5, 2.0), decimal(random, 0.5, 2.0), 1.0);
    let end = [last, root(random.pick([Support::Free, Support::Pinned, Support::Fixed]))];
    if random.chance(0.5) {
        return [first, end.to_vec()].concat();
    }
    let second = path(random);
    joint(&[&first, &second], &end)
}

/// Searches of all kinds.
pub(crate) fn run(seeds: impl IntoIterator<Item = u64>) -> Tally {
    let mut sum = Tally::default();
    let tally = &mut sum;
    for seed in seeds {
        let tree = tree(seed);
        let model = Stiffness::of(&tree);
        tally.models += 1;
        let random = &mut Random(seed);
        first_frequencies::<6>(&tree, &model, tally);
        frequencies_up_to(&tree, decimal(random, 1.0, 30.0), &model, tally);
        counts_up_to(&tree, 30.0, random, &model, tally);
        first_eigenvalues::<4>(&tree, &model, tally);
    }
    sum
}

//! Two equal levers on one axle: the right answer is that of one lever of twice the mass, or that something is held twice.

use super::parts::{beam, body, decimal, joint, root, tip};
use super::searches::{counts_up_to, first_eigenvalues, first_frequencies, frequencies_up_to};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::random_tree::Random;
use crate::support::tree::Tree;
use mstmm::element::Support;

/// A random model in three orders of the paths into its joint, and the same with one lever.
fn levers(seed: u64) -> ([Tree; 3], Tree) {
    let random = &mut Random(seed);
    let is_massless = random.unit() < 0.5;
    let mut number = |from, to| decimal(random, from, to);
    let (first, last) = (beam(number(0.3, 3.0), number(0.5, 2.0), 1.0), beam(number(0.3, 3.0), number(0.5, 2.0), 1.0));
    let (offset, centre, mass) = (number(0.3, 3.0), number(-0.5, 1.0), number(0.1, 2.0));
    let mass = if is_massless { 0.0 } else { mass };
    let inertia = mass * centre * centre + mass * number(0.05, 1.0);
    let arm: Tree = vec![tip(Support::Fixed), first];
    let lever: Tree = vec![tip(Support::Pinned), body(mass, inertia, offset, centre)];
    let both: Tree = vec![tip(Support::Pinned), body(2.0 * mass, 2.0 * inertia, offset, centre)];
    let end = [last, root(Support::Free)];
    let orders = [[&arm, &lever, &lever], [&lever, &arm, &lever], [&lever, &lever, &arm]];
    (orders.map(|paths| joint(&paths, &end)), joint(&[&arm, &both], &end))
}

pub(crate) fn run(models: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..models {
        let (orders, single) = levers(seed);
        let model = Stiffness::of(&single).held_twice();
        tally.models += 1;
        for tree in orders {
            tally.entry(Stiffness::of(&tree).is_held_twice, &("levers of one length are not two", &tree));
            let random = &mut Random(seed);
            first_frequencies::<4>(&tree, &model, &mut tally);
            frequencies_up_to(&tree, decimal(random, 1.0, 30.0), &model, &mut tally);
            counts_up_to(&tree, 30.0, random, &model, &mut tally);
            first_eigenvalues::<4>(&tree, &model, &mut tally);
        }
    }
    tally
}

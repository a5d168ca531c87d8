//! Heavy bodies behind levers, whose inertia is that of a point in one of three, to the last bits.

use super::parts::{beam, body, decimal, joint, root, tip};
use super::searches::first_frequencies;
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::random_tree::Random;
use crate::support::tree::{Part, Tree};
use mstmm::element::Support;
use mstmm::elements::Lever;
use mstmm::list::ListStep;

/// A beam, a lever, a body of 10 to 1e8 times the mass of the beam, now and then a lever back.
fn arm(random: &mut Random) -> Tree {
    let mut number = |from, to| decimal(random, from, to);
    let (length, stiffness, m) = (number(0.5, 2.0), number(0.5, 2.0), number(0.5, 2.0));
    let (centre, output_x, reach) = (number(-1.5, 1.5), number(-1.0, 1.0), number(0.3, 3.0));
    let mass = 10f64.powf(number(1.0, 8.0)) * m * length;
    let inertia = mass * centre * centre * (1.0 + random.pick([0.0, 1e-6, 0.5])) + random.pick([0.0, 0.0, 1.0]);
    let output_x = random.pick([0.0, centre, output_x]);
    let lever = random.pick([1.0, -1.0]) * reach;
    let step = |output_x: f64| ListStep::Element(Part::Lever(Lever { output_x }));
    let mut arm = vec![beam(length, stiffness, m), step(lever), body(mass, inertia, output_x, centre)];
    if random.chance(0.4) {
        arm.push(step(-lever));
    }
    arm
}

/// One or two arms in a row, then a beam; or two arms that meet there.
fn tree(seed: u64) -> Tree {
    let random = &mut Random(seed ^ 0x4ea7);
    let path = |random: &mut Random| -> Tree {
        let support = random.pick([Support::Fixed, Support::Fixed, Support::Pinned, Support::Guided]);
        let arms = 1 + random.below(2);
        [tip(support)].into_iter().chain((0..arms).flat_map(|_| arm(random))).collect()
    };
    let first = path(random);
    let last = beam(decimal(random, 0.5, 2.0), decimal(random, 0.5, 2.0), 1.0);
    let end = [last, root(random.pick([Support::Free, Support::Pinned, Support::Fixed]))];
    if random.chance(0.6) {
        return [first, end.to_vec()].concat();
    }
    joint(&[&first, &path(random)], &end)
}

pub(crate) fn run(models: u64) -> Tally {
    let mut tally = Tally::default();
    for tree in (0..models).map(tree) {
        tally.models += 1;
        first_frequencies::<6>(&tree, &Stiffness::of(&tree), &mut tally);
    }
    tally
}

//! Heavy bodies whose inertia is that of a point: `J_I - m c²` is what counts where the point rests.

use super::parts::{beam, body, damper, decimal, joint, root, tip};
use super::searches::{first_eigenvalues, intervals_and_discs};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::random_tree::Random;
use crate::support::tree::Tree;
use mstmm::element::Support;

/// Masses in those of the beam.
pub(crate) const RATIOS: [f64; 11] = [1.0, 3.0, 10.0, 30.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8];

/// Inertias about the mass centre in `m c²`.
pub(crate) const CENTRAL: [f64; 2] = [0.0, 1e-3];

/// A cantilever with a dashpot and a body on an arm at its tip.
fn damped(ratio: f64, central: f64, seed: u64) -> Tree {
    let random = &mut Random(seed ^ ratio.to_bits());
    let mut number = |from, to| decimal(random, from, to);
    let (length, m, centre) = (number(0.5, 2.0), number(0.5, 2.0), number(0.3, 2.0));
    let mass = ratio * m * length;
    let inertia = mass * centre * centre * (1.0 + central);
    let arm = vec![tip(Support::Fixed), beam(length, number(0.5, 2.0), m)];
    let dashpot = vec![tip(Support::Fixed), damper(number(0.05, 1.0))];
    joint(&[&arm, &dashpot], &[body(mass, inertia, centre, centre), root(Support::Free)])
}

pub(crate) fn run_damped(ratio: f64, central: f64, models: u64) -> Tally {
    let mut tally = Tally::default();
    for tree in (0..models).map(|seed| damped(ratio, central, seed)) {
        tally.models += 1;
        first_eigenvalues::<6>(&tree, &Stiffness::of(&tree), &mut tally);
    }
    tally
}

/// The body at the free end of a cantilever.
fn undamped(ratio: f64, central: f64, seed: u64) -> Tree {
    let random = &mut Random(seed ^ ratio.to_bits());
    let mut number = |from, to| decimal(random, from, to);
    let (length, m, centre) = (number(0.5, 2.0), number(0.5, 2.0), number(-2.0, 2.0));
    let mass = ratio * m * length;
    let inertia = mass * centre * centre * (1.0 + central);
    let body = body(mass, inertia, number(-1.0, 1.0), centre);
    vec![tip(Support::Free), body, beam(length, number(0.5, 2.0), m), root(Support::Fixed)]
}

/// Intervals and discs.
pub(crate) fn run_undamped(ratio: f64, central: f64, models: u64) -> [Tally; 2] {
    intervals_and_discs((0..models).map(|seed| undamped(ratio, central, seed)))
}

/// Inertias about the mass centre, in `m c²`, of bodies that are pinned there.
pub(crate) const PINNED: [f64; 11] = [1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10];

/// A body that is pinned at its mass centre and holds a beam there.
fn pinned(central: f64, seed: u64) -> Tree {
    let random = &mut Random(seed ^ central.to_bits());
    let mut number = |from, to| decimal(random, from, to);
    let (mass, centre) = (number(0.3, 3.0), number(0.3, 2.0));
    let inertia = mass * centre * centre * (1.0 + central);
    let arm = vec![tip(Support::Free), body(mass, inertia, centre, centre)];
    let pin = vec![tip(Support::Pinned)];
    let beam = beam(number(0.5, 2.0), number(0.5, 2.0), number(0.5, 2.0));
    joint(&[&arm, &pin], &[beam, root([Support::Fixed, Support::Free][(seed % 2) as usize])])
}

/// Intervals and discs.
pub(crate) fn run_pinned(central: f64, models: u64) -> [Tally; 2] {
    intervals_and_discs((0..models).map(|seed| pinned(central, seed)))
}

//! Levers there and back: what is far away moves with what is near.

use super::parts::{beam, body, conn, decimal, hinge, root, tip};
use super::searches::intervals_and_discs;
use super::tally::Tally;
use crate::support::random_tree::Random;
use crate::support::tree::Tree;
use mstmm::element::Support;

/// Lengths of the levers, decades \[m\].
pub(crate) const DECADES: core::ops::RangeInclusive<i32> = 2..=10;

/// What is between the levers: nothing, a mass far away, a hinge, a pin.
const KINDS: u64 = 4;

pub(crate) fn lever(decade: i32, seed: u64) -> Tree {
    let random = &mut Random(seed + 1000 * decade.unsigned_abs() as u64);
    let mut number = |from, to| decimal(random, from, to);
    let offset = number(0.5, 2.0) * 10f64.powi(decade);
    let near = body(number(0.2, 2.0), number(0.2, 2.0), offset, 0.0);
    let massless = body(0.0, 0.0, -offset, 0.0);
    let mut tree = vec![tip(Support::Fixed), beam(number(0.5, 2.0), number(0.5, 2.0), 1.0), near];
    match seed % KINDS {
        0 => tree.push(massless),
        1 => tree.push(body(number(0.2, 2.0), number(0.2, 2.0), -offset, 0.0)),
        2 => tree.extend([hinge(number(0.5, 20.0), number(0.5, 20.0)), massless]),
        _ => tree.extend([tip(Support::Pinned), conn(2), massless]),
    }
    let end = [Support::Free, Support::Pinned][(seed / KINDS % 2) as usize];
    tree.extend([beam(number(0.5, 2.0), number(0.5, 2.0), 1.0), root(end)]);
    tree
}

/// Intervals and discs.
pub(crate) fn run(decade: i32, models: u64) -> [Tally; 2] {
    intervals_and_discs((0..models).map(|seed| lever(decade, seed)))
}

//! Random trees: laws, products and energies of their first modes.

use crate::mode_shapes::checks::{check_energies, check_laws, check_orthogonality};
use crate::mode_shapes::multiple::check_basis;
use crate::mode_shapes::recorded::Recordable;
use crate::support::list_of_tree::{any, undamped};
use crate::support::random_tree::random_tree;
use crate::support::tree::Tree;
use mstmm::motion::Root;
use mstmm::number::Oscillation;
use mstmm::prelude::*;
use mstmm::search::System;

/// Beams of a tree.
const BEAMS: usize = 3;

/// Trees of moderate size that have a spectrum, without dashpots and with.
const UNDAMPED: [u64; 24] =
    [2, 6, 7, 14, 15, 16, 17, 18, 22, 31, 35, 36, 39, 43, 44, 45, 48, 51, 53, 55, 63, 64, 67, 70];
const DAMPED: [u64; 16] = [2, 7, 16, 31, 35, 39, 43, 53, 90, 102, 116, 118, 119, 124, 132, 141];

/// Checks the shapes of some roots of a tree.
fn check<Y, S, R>(seed: u64, tree: &Tree, system: &Y, roots: &[R])
where
    S: Oscillation<f64>,
    Y: Recordable<S> + System<Parameter = f64>,
    R: Root<f64, Frequency = S> + core::fmt::Debug,
{
    let residual = check_laws(tree, system, roots);
    let products = check_orthogonality(system, roots);
    let energies = check_energies(tree, system, roots);
    println!("{seed}: {} roots, {residual:?}, {products:e}, {energies:e}", roots.len());
}

/// The first ten natural frequencies, or those of a tree that has fewer.
fn frequencies(system: &impl Undamped<Parameter = f64>) -> Vec<NaturalFrequency> {
    let finite = system.count_below(1e12).unwrap().min(10);
    let mut roots: Vec<NaturalFrequency> = Vec::new();
    let mut upper = 1.0;
    while roots.iter().map(|root| root.multiplicity).sum::<u64>() < finite {
        roots = system.natural_frequencies::<64>(0.0..=upper).unwrap().to_vec();
        upper *= 2.0;
    }
    roots
}

#[test]
fn undamped_trees() {
    for seed in UNDAMPED {
        let tree = random_tree(seed, BEAMS, false);
        let system = undamped::<f64>(&tree);
        let roots = frequencies(&system);
        roots.iter().filter(|root| root.multiplicity > 1).for_each(|root| check_basis(&tree, &system, root));
        check(seed, &tree, &system, &roots);
    }
}

#[test]
fn damped_trees() {
    for seed in DAMPED {
        let tree = random_tree(seed, BEAMS, true);
        let system = any::<f64>(&tree);
        let roots = system.eigenvalues::<64>(Region { re: -6.0..=0.5, im: 0.0..=6.0 }).unwrap();
        check(seed, &tree, &system, &roots);
    }
}

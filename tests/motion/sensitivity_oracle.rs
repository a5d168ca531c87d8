//! Sensitivities of random trees, to all parameters of all elements, against differences of the determinant of linear
//! equations for all their states.
#![expect(clippy::unwrap_used, reason = "a failing tree is shown as a whole")]

use crate::state_equations::{StateEquations, Wide};
use crate::support::list_of_tree::{MOST, any};
use crate::support::random_tree::{jointed, varied_tree};
use crate::support::tree::Tree;
use core::ops::Range;
use mstmm::Complex;
use mstmm::list::ListStep;
use mstmm::motion::ModalAnalysis;
use mstmm::number::Parameter;
use mstmm::search::{Eigenvalue, Eigenvalues, Region};

/// Eigenvalues above zero, of beams whose waves the equations follow.
const REGION: Region = Region { re: -30.0..=1.0, im: 0.05..=8.0 };

/// Relative step of a parameter: the square of it, times the third derivative of the determinant, is below [`LIMIT`].
const STEP: f64 = 1.0 / (1_u64 << 24) as f64;

/// What the differences leave, and roots that are no closer to another than [`APART`].
const LIMIT: f64 = 4e-11;
const APART: f64 = 1e-3;

fn narrow(z: Wide) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}

fn wide(z: Complex<f64>) -> Wide {
    Wide::new(z.re.into(), z.im.into())
}

/// A tree with one parameter changed, one that is zero by the step itself, and its value.
fn changed(tree: &Tree, step: usize, index: usize, factor: f64) -> (Tree, f64) {
    let (mut tree, mut value) = (tree.clone(), 0.0);
    if let ListStep::Element(part) = &mut tree[step] {
        let parameter = &mut part.parameters()[index];
        **parameter = if **parameter == 0.0 { factor - 1.0 } else { **parameter * factor };
        value = **parameter;
    }
    (tree, value)
}

/// The root of the determinant next to an eigenvalue, and the derivative there; `None` if the equations are too inexact.
fn polished(equations: &StateEquations, tree: &Tree, root: &Eigenvalue) -> Option<(Wide, Wide)> {
    let step = wide(Complex::from(root.lambda.norm() * 2f64.powi(-30)));
    let slope =
        |x: Wide| (equations.determinant(tree, x + step) - equations.determinant(tree, x - step)) / (step + step);
    let mut x = wide(root.lambda);
    for _ in 0..2 {
        x -= equations.determinant(tree, x) / slope(x);
    }
    let error = (narrow(x) - root.lambda).norm() / root.lambda.norm();
    (error < 1e-11).then(|| (x, slope(x)))
}

/// Compares all sensitivities of a tree; returns how many there were.
fn check(seed: u64, tree: &Tree) -> usize {
    let (equations, system) = (StateEquations::new(tree), any::<f64>(tree));
    let Ok(roots) = system.eigenvalues::<64>(REGION) else { return 0 };
    let is_alone = |root: &Eigenvalue| {
        let near = |other: &&Eigenvalue| (other.lambda - root.lambda).norm() < APART;
        root.multiplicity == 1 && roots.iter().filter(near).count() == 1
    };
    let mut compared = 0;
    for root in roots.iter().filter(|root| is_alone(root)) {
        let Some((x, slope)) = polished(&equations, tree, root) else { continue };
        let sensitivities = system.sensitivity(root).unwrap();
        for (step, part) in tree.iter().enumerate() {
            let ListStep::Element(part) = part else { continue };
            for (index, name) in part.names().iter().enumerate() {
                let [(above, a), (below, b)] =
                    [1.0 + STEP, 1.0 - STEP].map(|factor| changed(tree, step, index, factor));
                let difference = equations.determinant(&above, x) - equations.determinant(&below, x);
                let expected = -narrow(difference / slope) / (a - b);
                let actual = sensitivities.of(system.parameter(step, name).unwrap());
                let size = if part.named()[index].1 == 0.0 { 1.0 } else { a.abs() };
                let scale = expected.norm().max(1e-3 * root.lambda.norm() / size);
                assert!(
                    (actual - expected).norm() <= LIMIT * scale,
                    "seed {seed}, {}, step {step}, {name}: {actual}, {expected}\nvec!{tree:?}",
                    root.lambda
                );
                compared += 1;
            }
        }
    }
    compared
}

/// Compares those of some trees; returns how many there were.
fn compared(seeds: Range<u64>) -> usize {
    let trees = seeds.map(|seed| (seed, varied_tree(seed))).filter(|(_, tree)| tree.len() <= MOST);
    trees.map(|(seed, tree)| check(seed, &tree)).sum()
}

#[test]
fn some_sensitivities_are_those_of_the_determinant() {
    let compared = compared(0..10);
    assert!(compared > 100, "{compared}");
}

/// To the stiffness of hinges of one freedom, where it is zero, too, and to the lengths of levers.
#[test]
fn some_sensitivities_of_jointed_trees_are_those_of_the_determinant() {
    let trees = (0..12).map(|seed| (seed, jointed(&varied_tree(seed), seed))).filter(|(_, tree)| tree.len() <= MOST);
    let compared: usize = trees.map(|(seed, tree)| check(seed, &tree)).sum();
    assert!(compared > 100, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn sensitivities_are_those_of_the_determinant() {
    let compared = compared(0..50);
    assert!(compared > 1000, "{compared}");
}

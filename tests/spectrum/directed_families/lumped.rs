//! Finitely many eigenvalues: springs, dashpots and masses. All of them are known to be there.

use super::parts::{decimal, mass, root, spring_damper, tip};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::list_of_tree::any_steps;
use crate::support::random_tree::Random;
use crate::support::tree::Tree;
use mstmm::Complex;
use mstmm::element::Support;
use mstmm::list::{AnyElement, StepList};
use mstmm::search::SearchError;
use mstmm::search::{Eigenvalue, Eigenvalues, Region};

/// A chain of pairs of a spring with a dashpot and a mass, from the ground.
fn chain(links: &[[f64; 3]]) -> Tree {
    let mut tree = vec![tip(Support::Fixed)];
    tree.extend(links.iter().flat_map(|&[stiffness, damping, m]| [spring_damper(stiffness, damping), mass(m)]));
    tree.push(root(Support::Free));
    tree
}

/// The first eigenvalues, as many as there are masses: each mass has one at least in the closed upper half plane.
fn first(list: &StepList<'_, AnyElement<f64>>, masses: usize) -> Result<Vec<Eigenvalue>, SearchError> {
    match masses {
        1 => list.first_eigenvalues::<1>().map(|found| found.to_vec()),
        2 => list.first_eigenvalues::<2>().map(|found| found.to_vec()),
        3 => list.first_eigenvalues::<3>().map(|found| found.to_vec()),
        4 => list.first_eigenvalues::<4>().map(|found| found.to_vec()),
        5 => list.first_eigenvalues::<5>().map(|found| found.to_vec()),
        _ => list.first_eigenvalues::<6>().map(|found| found.to_vec()),
    }
}

/// `1e4` times the frequency of the stiffest link on the lightest mass: an overdamped mass may be faster than all others.
fn far(links: &[[f64; 3]]) -> f64 {
    let fold = |index: usize, of: fn(f64, f64) -> f64, start: f64| links.iter().map(|link| link[index]).fold(start, of);
    let (k, c, m) = (fold(0, f64::max, 0.0), fold(1, f64::max, 0.0), fold(2, f64::min, f64::INFINITY));
    // Gershgorin's bound of `λ² m = -(λ c + k)` with two links at a mass
    4.0 * c / m + 2.0 * (k / m).sqrt() + 1.0
}

/// Whether two discs meet.
fn meet(a: &Eigenvalue, b: &Eigenvalue) -> bool {
    (a.lambda - b.lambda).norm() <= a.error + b.error
}

/// What a region holds, and the first ones: the same, and all there are.
fn check(links: &[[f64; 3]], tally: &mut Tally) {
    let tree = chain(links);
    let model = Stiffness::of(&tree);
    let steps = any_steps::<f64>(&tree);
    let list = StepList::new(&steps).unwrap();
    tally.models += 1;
    let far = far(links);
    let region = match list.eigenvalues::<32>(Region { re: -far..=0.1 * far, im: 0.0..=far }) {
        Ok(found) => found.to_vec(),
        Err(error) => return tally.refusal(&error),
    };
    tally.verdicts(&model.judge_discs(&region), &(links, "in a region"));
    let is_real = |root: &Eigenvalue| root.lambda.im.abs() <= root.error;
    let share = |root: &Eigenvalue| if is_real(root) { root.multiplicity } else { 2 * root.multiplicity };
    let all: u64 = region.iter().map(share).sum();
    tally.entry(all == 2 * links.len() as u64, &(links, "in a region", &region));
    match first(&list, links.len()) {
        Err(error) => {
            tally.refusal(&error);
            tally.entry(false, &(links, error));
        }
        Ok(found) => {
            tally.verdicts(&model.judge_discs(&found), &(links, "the first"));
            let mut sorted = region.clone();
            sorted.sort_by(|a, b| a.lambda.norm().total_cmp(&b.lambda.norm()));
            // those of one modulus may come in any order
            let reach = found.last().map_or(0.0, |last| last.lambda.norm() + last.error);
            let number: u64 = found.iter().map(|root| root.multiplicity).sum();
            let nearer = sorted.iter().filter(|root| root.lambda.norm() + root.error < reach * (1.0 - 1e-12));
            let are_first = nearer.clone().all(|root| found.iter().any(|other| meet(root, other)));
            let are_there = found.iter().all(|root| sorted.iter().any(|other| meet(root, other)));
            let is_right = number >= links.len() as u64 && are_first && are_there;
            tally.entry(is_right, &(links, &found, &sorted));
        }
    }
}

/// Wheel and body of a car of ordinary numbers.
pub(crate) fn quarter_cars(models: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..models {
        let random = &mut Random(seed);
        let mut number = |from: f64, to: f64| decimal(random, from, to);
        let tyre = [number(1e5, 3e5), number(0.0, 200.0), number(20.0, 60.0)];
        let strut = [number(1e4, 4e4), number(300.0, 5000.0), number(200.0, 500.0)];
        check(&[tyre, strut], &mut tally);
    }
    tally
}

/// Chains of one to six masses; every second one of equal links.
pub(crate) fn chains(models: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in 0..models {
        let random = &mut Random(seed);
        let masses = 1 + (random.unit() * 6.0) as usize;
        let mut link = || {
            let (stiffness, damping) = (decimal(random, 0.1, 10.0), decimal(random, 0.0, 2.0));
            [stiffness, damping, decimal(random, 0.1, 10.0)]
        };
        let common = link();
        let links: Vec<[f64; 3]> = (0..masses).map(|_| if seed % 2 == 0 { link() } else { common }).collect();
        check(&links, &mut tally);
    }
    tally
}

/// Frequencies from 32 to 35.2 in 100 steps and damping ratios from 0 to 1 in 156: `λ = -ζω ± iω sqrt(1 - ζ²)`.
pub(crate) fn oscillators(stride: usize) -> Tally {
    let mut tally = Tally::default();
    for index in (0..15_600_u32).step_by(stride) {
        let (w, z) = (32.0 + 3.2 * f64::from(index % 100) / 100.0, f64::from(index / 100) / 156.0);
        let tree = chain(&[[w * w, 2.0 * z * w, 1.0]]);
        let steps = any_steps::<f64>(&tree);
        tally.models += 1;
        match StepList::new(&steps).unwrap().first_eigenvalues::<1>() {
            Err(error) => {
                tally.refusal(&error);
                tally.entry(false, &(w, z, error));
            }
            Ok(found) => {
                let expected = Complex::new(-z * w, w * (1.0 - z * z).sqrt());
                // near the critical damping, what rounding does to ζ² counts for more
                let rounding = 8.0 * f64::EPSILON * w / (1.0 - z * z).sqrt();
                let distance = (found[0].lambda - expected).norm();
                tally.entry(distance <= found[0].error + rounding, &(w, z, &found[0]));
                tally.verdicts(&Stiffness::of(&tree).judge_discs(&found), &(w, z));
            }
        }
    }
    tally
}

//! Counts and natural frequencies of random trees against a finite element model that shares no formula with the
//! library.
//!
//! Oracle: polynomials of degree 41 and less per beam, assembled by degrees of freedom; Sylvester's law counts its
//! frequencies. A list of frequencies is right if the oracle counts as many below and above each of them as the list.
#![expect(clippy::panic, clippy::unwrap_used, reason = "a failing tree is shown as a whole")]

use crate::oracles::finite_elements::Model;
use crate::oracles::legendre_beam::LegendreBeam;
use crate::support::list_of_tree::{any_steps, undamped_steps};
use crate::support::random_tree::{Random, jointed, random_tree};
use crate::support::roots::bisect;
use crate::support::tree::{Part, Tree};
use core::f64::consts::PI;
use mstmm::Complex;
use mstmm::element::Support;
use mstmm::elements::Beam;
use mstmm::list::{ListStep, StepList};
use mstmm::number::Dual;
use mstmm::search::Characteristic;
use mstmm::search::{Eigenvalue, Eigenvalues, Region};
use mstmm::search::{NaturalFrequencies, NaturalFrequency};
use std::sync::LazyLock;

/// Inner functions of a beam in the oracle.
const ORDER: usize = 40;

/// Largest `z = βl` of a beam up to which the oracle has converged: ten half waves.
const LIMIT: f64 = 31.0;

/// Modes to compare, more where several coincide.
const MODES: u64 = 10;

/// Relative error of a frequency of the oracle beside its rounding, see `the_oracle_has_converged`.
const CONVERGED: f64 = 1e-11;

static ELEMENT: LazyLock<LegendreBeam> = LazyLock::new(|| LegendreBeam::new(ORDER));

/// The first `count` random trees of up to `beams` beams that have a spectrum, starting from a seed.
fn trees(seed: u64, count: usize, beams: usize, damped: bool) -> impl Iterator<Item = (u64, Tree, Model<'static>)> {
    let usable = move |seed: u64| {
        let tree = random_tree(seed, beams, damped);
        let model = Model::of(&tree, &ELEMENT)?;
        model.check().is_ok().then_some((seed, tree, model))
    };
    (seed..).filter_map(usable).take(count)
}

/// Relative error of a frequency of the oracle.
fn error(model: &Model<'_>, omega: f64) -> f64 {
    CONVERGED + model.rounding(omega)
}

/// The list of frequencies says the same as the oracle on both sides of each certified interval.
fn check_frequencies(found: &[NaturalFrequency], model: &Model<'_>, end: f64) -> Result<(), String> {
    // rounding makes rigid-body modes of the oracle no more than this
    let rigid = |root: &&NaturalFrequency| model.rounding(root.omega) > 1e-2;
    let (zero, mut rest) = found.split_at(found.iter().take_while(rigid).count());
    let mut below = zero.iter().map(|root| root.multiplicity).sum::<u64>();
    let low = rest.first().map_or(end, |root| root.omega) * 0.5;
    if model.count_below(low) != below {
        return Err(format!("{below} instead of {} at zero", model.count_below(low)));
    }
    while let [first, ..] = rest {
        // frequencies that the oracle cannot tell apart are compared together
        let apart =
            |pair: &[NaturalFrequency]| pair[1].lower > pair[0].upper * (1.0 + 3.0 * error(model, pair[0].omega));
        let cluster = rest.windows(2).position(apart).map_or(rest.len(), |last| last + 1);
        let last = &rest[cluster - 1];
        let above: u64 = below + rest[..cluster].iter().map(|root| root.multiplicity).sum::<u64>();
        let ends = (first.lower * (1.0 - error(model, first.omega)), last.upper * (1.0 + error(model, last.omega)));
        let counts = (model.count_below(ends.0), model.count_below(ends.1));
        if counts != (below, above) {
            return Err(format!("{counts:?} instead of {:?} below and above {:?}", (below, above), &rest[..cluster]));
        }
        (below, rest) = (above, &rest[cluster..]);
    }
    Ok(())
}

/// Counts at random frequencies, then all frequencies up to the first ten or more.
fn check(seed: u64, tree: &Tree, model: &Model<'_>) -> Result<(), String> {
    let steps = undamped_steps(tree);
    let list = StepList::new(&steps).map_err(|error| error.to_string())?;
    let zero = model.count_below(1e-3);
    let end = model.frequency_above(zero + MODES, LIMIT);
    let mut random = Random(seed);
    for _ in 0..3 {
        let omega = end * (0.01 + 0.99 * random.unit());
        let error = error(model, omega);
        let expected = model.count_below(omega * (1.0 - error));
        if expected == model.count_below(omega * (1.0 + error)) && list.count_below(omega) != Ok(expected) {
            return Err(format!("{:?} instead of {expected} below {omega}", list.count_below(omega)));
        }
    }
    let found = list.natural_frequencies::<64>(0.0..=end).map_err(|error| error.to_string())?;
    check_frequencies(&found, model, end)?;
    let total: u64 = found.iter().map(|root| root.multiplicity).sum();
    let margin = end * error(model, end);
    let expected = model.count_below(end - margin)..=model.count_below(end + margin);
    if expected.contains(&total) { Ok(()) } else { Err(format!("{total} instead of {expected:?} up to {end}")) }
}

/// Checks trees; a failure shows how to build the tree again.
fn check_trees(seed: u64, count: usize) {
    for (seed, tree, model) in trees(seed, count, 8, false) {
        if let Err(problem) = check(seed, &tree, &model) {
            panic!("seed {seed}: {problem}\nvec!{tree:?}");
        }
    }
}

#[test]
fn frequencies_and_counts_of_some_trees() {
    check_trees(0, 40);
}

/// With hinges of one freedom and levers.
#[test]
fn frequencies_and_counts_of_some_jointed_trees() {
    let mut compared = 0;
    for seed in 0..60 {
        let tree = jointed(&random_tree(seed, 5, false), seed);
        let Some(model) = Model::of(&tree, &ELEMENT).filter(|model| model.check().is_ok()) else { continue };
        if let Err(problem) = check(seed, &tree, &model) {
            panic!("seed {seed}: {problem}\nvec!{tree:?}");
        }
        compared += 1;
    }
    assert!(compared > 30, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn frequencies_and_counts_of_trees_1() {
    check_trees(0, 250);
}

#[test]
#[ignore = "long: .ci/long"]
fn frequencies_and_counts_of_trees_2() {
    check_trees(100_000, 250);
}

/// Eigenvalues of the oracle are zeros of Δ: Newton's step from there stays within the oracle's error.
fn compared(count: usize) -> usize {
    let mut compared = 0;
    for (seed, tree, model) in trees(0, count, 2, true) {
        let steps = any_steps(&tree);
        let list = StepList::new(&steps).unwrap();
        let values = model.eigenvalues();
        // at a multiple zero Δ loses half of its digits, and Newton's step with them
        let near = |a: &Complex<f64>, b: &Complex<f64>| (a - b).norm() < 1e-3 * a.norm();
        for &lambda in values.iter().filter(|a| values.iter().filter(|b| near(a, b)).count() == 1) {
            let delta = list.characteristic(Dual::variable(lambda)).mantissa();
            let step = (delta.value / delta.derivative).norm() / lambda.norm();
            let bound = 10.0 * error(&model, lambda.norm());
            assert!(step < bound, "seed {seed}: {lambda} moves by {step:e} of it\nvec!{tree:?}");
            compared += 1;
        }
    }
    compared
}

#[test]
fn eigenvalues_of_some_damped_trees() {
    let compared = compared(20);
    assert!(compared > 50, "{compared} eigenvalues only");
}

#[test]
#[ignore = "long: .ci/long"]
fn eigenvalues_of_damped_trees() {
    let compared = compared(200);
    assert!(compared > 500, "{compared} eigenvalues only");
}

/// A rectangle around the lowest of the oracle's refined eigenvalues whose edges keep away from all estimates; none that
/// are zero.
fn rectangle(estimates: &[Complex<f64>], refined: &[Complex<f64>]) -> Option<Region> {
    let mut sizes: Vec<f64> = refined.iter().map(|lambda| lambda.norm()).collect();
    sizes.sort_by(f64::total_cmp);
    let high = *sizes.get(sizes.len().min(10).checked_sub(1)?)? * 1.05;
    let low = sizes.first()? * 0.3;
    let near = |a: f64, b: f64| (a - b).abs() < 0.04 * high;
    let keeps_away = |lambda: &Complex<f64>| {
        !near(lambda.re, -high)
            && !near(lambda.im, high)
            && (lambda.im.abs() < 1e-6 * high || (lambda.im - low).abs() > 0.1 * low)
    };
    estimates.iter().all(keeps_away).then_some(Region { re: -high..=0.05 * high, im: low..=high })
}

/// The oracle's eigenvalues in a rectangle are those of the library, and no more: by the linearised pencil, whose
/// estimates are good to a few percent.
fn compared_in_rectangles(count: usize) -> u64 {
    let mut compared = 0;
    for (seed, tree, model) in trees(0, count, 2, true) {
        let steps = any_steps(&tree);
        let list = StepList::new(&steps).unwrap();
        let estimates = model.linearised();
        let refined = model.eigenvalues();
        let Some(region) = rectangle(&estimates, &refined) else { continue };
        let inside = |lambda: &Complex<f64>| region.re.contains(&lambda.re) && region.im.contains(&lambda.im);
        let expected = estimates.iter().filter(|lambda| inside(lambda)).count() as u64;
        let found = list.eigenvalues::<64>(region.clone()).unwrap();
        let total: u64 = found.iter().map(|root| root.multiplicity).sum();
        assert_eq!(total, expected, "seed {seed}: {region:?}, {estimates:?}\nvec!{tree:?}");
        assert_eq!(list.count_in(region.clone()), Ok(total), "seed {seed}");
        for lambda in refined.iter().filter(|lambda| inside(lambda)) {
            let distance = |root: &Eigenvalue| (root.lambda - lambda).norm() - root.error;
            let nearest = found.iter().map(distance).fold(f64::INFINITY, f64::min);
            // at a multiple eigenvalue the oracle has half of its digits
            let bound = lambda.norm() * (10.0 * error(&model, lambda.norm())).max(CONVERGED.sqrt());
            assert!(nearest < bound, "seed {seed}: {lambda} is {nearest:e} from the nearest\nvec!{tree:?}");
        }
        compared += total;
    }
    compared
}

#[test]
fn some_rectangles_hold_the_eigenvalues_of_the_oracle() {
    let compared = compared_in_rectangles(20);
    assert!(compared > 40, "{compared} eigenvalues only");
}

#[test]
#[ignore = "long: .ci/long"]
fn rectangles_hold_the_eigenvalues_of_the_oracle() {
    let compared = compared_in_rectangles(200);
    assert!(compared > 400, "{compared} eigenvalues only");
}

/// Closed form of a cantilever, `cos z + 1/ch z = 0`, up to the tenth mode; and of the inner modes, which are those of a
/// clamped beam, `cos z = 1/ch z`.
#[test]
fn the_oracle_has_converged() {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    let tree = vec![ListStep::Tip(Support::Fixed), ListStep::Element(Part::Beam(beam)), ListStep::Root(Support::Free)];
    let model = Model::of(&tree, &ELEMENT).unwrap();
    let modes = (0..10).map(|k| f64::from(k) * PI);
    for (k, start) in modes.enumerate() {
        let z = bisect(|z| z.cos() + 1.0 / z.cosh(), start, start + PI);
        let margin = error(&model, z * z);
        let counts = [1.0 - margin, 1.0 + margin].map(|factor| model.count_below(z * z * factor));
        assert_eq!(counts, [k as u64, k as u64 + 1], "mode {k}");
        if k > 0 {
            let clamped = bisect(|z| z.cos() - 1.0 / z.cosh(), start + 0.5, start + 0.5 + PI);
            let inner = (16.0 / ELEMENT.inner[k - 1]).powf(0.25);
            assert!((inner / clamped - 1.0).abs() < CONVERGED, "inner mode {k} at {inner} instead of {clamped}");
        }
    }
}

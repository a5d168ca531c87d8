//! Responses of random trees, all loads to all entries, against linear equations for all their states.
#![expect(clippy::panic, clippy::unwrap_used, reason = "a failing tree is shown as a whole")]

mod at_rest;

use crate::state_equations::{StateEquations, Wide};
use crate::support::list_of_tree::{self, MOST, point};
use crate::support::random_tree::{Random, jointed, varied_tree};
use crate::support::tree::{Part, Tree};
use mstmm::Complex;
use mstmm::element::{Coordinate, Space};
use mstmm::elements::{Beam, Body};
use mstmm::list::{InList, ListStep};
use mstmm::motion::{Entry, Load, ModalAnalysis, Point};
use mstmm::number::{Parameter, Real};
use mstmm_core::Step;

/// Frequencies of 24 bits: undamped, decaying, growing, real, high.
const LAMBDAS: [(f64, f64); 5] = [(0.0, 0.75), (-0.25, 2.0), (0.5, 9.0), (-1.75, 0.0), (0.0, 30.0)];

/// Sum of the βl of all beams from which on the equations lose too many digits.
const LONGEST: f64 = 30.0;

/// Roundings of a response in units of eps, relative to the largest displacement or force under the load: one, and another of what it is compared
/// with.
const FACTOR: f64 = 2.0;

/// Roundings per unknown where there is no extended precision: some ten per entry of a state, and ten times that near resonances.
const PER_UNKNOWN: f64 = 100.0;

const ALL: [Coordinate; 4] = [Coordinate::Y, Coordinate::Theta, Coordinate::M, Coordinate::Q];

fn load(step: usize, coordinate: Coordinate) -> Load<InList> {
    if coordinate == Coordinate::Q { point(step, true).force() } else { point(step, true).torque() }
}

fn entry(point: Point<InList>, coordinate: Coordinate) -> Entry<InList> {
    match coordinate {
        Coordinate::Y => point.deflection(),
        Coordinate::Theta => point.rotation(),
        Coordinate::M => point.moment(),
        _ => point.shear(),
    }
}

fn is_force(coordinate: Coordinate) -> bool {
    matches!(coordinate, Coordinate::M | Coordinate::Q)
}

fn waves(tree: &Tree, lambda: Complex<f64>) -> f64 {
    let beam = |step: &ListStep<Part>| match *step {
        ListStep::Element(Part::Beam(Beam { length, bending_stiffness, mass_per_length })) => {
            length * (mass_per_length / bending_stiffness * lambda.norm_sqr()).powf(0.25)
        }
        _ => 0.0,
    };
    tree.iter().map(beam).sum()
}

/// Where a coordinate is at a step: at a connection that does not go on with it, at one of its inputs.
fn place(equations: &StateEquations, step: usize, coordinate: Coordinate) -> Option<usize> {
    let has = |step: usize| equations.spaces[step].coordinates().contains(&coordinate);
    let inputs = if let Step::Connection(inputs) = equations.steps[step] { inputs } else { &[] };
    let is_path = |input: &usize| !matches!(equations.steps[*input], Step::Tip(_));
    let input = inputs.iter().copied().find(|input| is_path(input) && has(*input));
    if has(step) { Some(step) } else { input }
}

/// Compares all responses of a tree at a frequency; returns how many there were.
fn check<T: Real>(seed: u64, tree: &Tree, lambda: Complex<f64>) -> usize {
    let (equations, system) = (StateEquations::new(tree), list_of_tree::any::<T>(tree));
    let wide = Wide::new(lambda.re.into(), lambda.im.into());
    let own = Complex::new(T::from_f64(lambda.re), T::from_f64(lambda.im));
    let roundings = if T::HAS_EXTENDED { FACTOR } else { PER_UNKNOWN * equations.unknowns as f64 };
    let limit = roundings * T::EPSILON;
    let steps = 0..tree.len() - 1;
    let mut compared = 0;
    for (at, jumping) in steps.clone().flat_map(|at| [(at, Coordinate::Q), (at, Coordinate::M)]) {
        let Some(source) = place(&equations, at, jumping) else { continue };
        // a force acts towards Y, a moment towards Θ
        let jump = if jumping == Coordinate::Q { 1.0 } else { -1.0 };
        let Some(states) = equations.solve(tree, wide, source, jumping, jump) else { continue };
        let value = |step: usize, coordinate: Coordinate| {
            let z = equations.entry(&states, step, coordinate);
            Complex::new(z.re.to_f64(), z.im.to_f64())
        };
        let largest = |force: bool| {
            let entries =
                steps.clone().flat_map(|step| equations.spaces[step].coordinates().iter().map(move |c| (step, *c)));
            let sizes = entries.filter(|(_, c)| is_force(*c) == force).map(|(step, c)| value(step, c).norm());
            sizes.fold(if force { 1.0 } else { 0.0 }, f64::max)
        };
        let largest = [largest(false), largest(true)];
        let asked = steps.clone().flat_map(|step| ALL.map(|coordinate| (step, coordinate)));
        for ((to, coordinate), beyond) in asked.flat_map(|asked| [(asked, false), (asked, true)]) {
            let Some(there) = place(&equations, to, coordinate) else { continue };
            let is_at_load = beyond && there == to && there == source && coordinate == jumping;
            let expected = value(there, coordinate) + if is_at_load { jump } else { 0.0 };
            let response = system.frequency_response(load(at, jumping), entry(point(to, beyond), coordinate)).unwrap();
            let actual =
                response.at(own).unwrap_or_else(|error| panic!("seed {seed} at {lambda}: {error}\nvec!{tree:?}"));
            let actual = Complex::new(actual.re.to_f64(), actual.im.to_f64());
            let error = (actual - expected).norm() / largest[usize::from(is_force(coordinate))].max(f64::MIN_POSITIVE);
            assert!(
                error <= limit || expected.norm() < NOTHING,
                "seed {seed} at {lambda}, {jumping:?} at {at}: {coordinate:?} at {to}, {beyond}: {actual}, {expected}, {error:e}\nvec!{tree:?}"
            );
            compared += 1;
        }
    }
    compared
}

/// Displacements that a load at a support leaves in the equations.
const NOTHING: f64 = 1e-18;

/// Trees and one of the frequencies for each.
fn cases(seeds: core::ops::Range<u64>) -> impl Iterator<Item = (u64, Tree, Complex<f64>)> {
    seeds.map(|seed| {
        let (re, im) = LAMBDAS[seed as usize % LAMBDAS.len()];
        (seed, varied_tree(seed), Complex::new(re, im))
    })
}

#[test]
fn responses_are_solutions_of_the_equations_of_all_states() {
    let usable = |(_, tree, lambda): &(u64, Tree, Complex<f64>)| tree.len() <= MOST && waves(tree, *lambda) < LONGEST;
    let compared: usize =
        cases(0..40).filter(usable).map(|(seed, tree, lambda)| check::<f64>(seed, &tree, lambda)).sum();
    assert!(compared > 10_000, "{compared}");
    let single: usize =
        cases(40..60).filter(usable).map(|(seed, tree, lambda)| check::<f32>(seed, &tree, lambda)).sum();
    assert!(single > 1000, "{single}");
}

/// Through hinges of one freedom, with stiffness and without, and through levers.
#[test]
fn responses_of_jointed_trees_are_solutions_of_the_equations() {
    let jointed = |(seed, tree, lambda): (u64, Tree, Complex<f64>)| (seed, jointed(&tree, seed), lambda);
    let usable = |(_, tree, lambda): &(u64, Tree, Complex<f64>)| tree.len() <= MOST && waves(tree, *lambda) < LONGEST;
    let mut compared = 0;
    for (seed, tree, lambda) in cases(0..20).map(jointed).filter(usable) {
        compared += check::<f64>(seed, &tree, lambda);
    }
    assert!(compared > 5_000, "{compared}");
}

/// Stiffnesses and masses up to a million times as large or as small as others: no digit of an answer is lost.
#[test]
fn responses_of_extreme_trees_are_solutions_of_the_equations() {
    let mut compared = 0;
    for (seed, mut tree, lambda) in cases(100..140) {
        let mut random = Random(seed);
        for step in &mut tree {
            let scale = 10.0_f64.powi(6 * (random.below(3) as i32 - 1));
            match step {
                ListStep::Element(Part::Beam(beam)) => beam.bending_stiffness *= scale,
                ListStep::Element(Part::Spring(spring)) => spring.stiffness *= scale,
                ListStep::Element(Part::Mass(mass)) => mass.mass *= scale,
                _ => {}
            }
        }
        if tree.len() <= MOST && waves(&tree, lambda) < LONGEST {
            compared += check::<f64>(seed, &tree, lambda);
        }
    }
    assert!(compared > 10_000, "{compared}");
}

/// A real ω and the complex λ = iω are the same frequency.
#[test]
fn real_and_complex_frequencies_agree() {
    let mut compared = 0;
    for seed in (1..60).step_by(2) {
        let tree = varied_tree(seed);
        if tree.len() > MOST {
            continue;
        }
        let (equations, system) = (StateEquations::new(&tree), list_of_tree::undamped::<f64>(&tree));
        let tip = tree.len() - 2;
        let (load_entry, own) = match equations.spaces[tip] {
            Space::Rotation => (Coordinate::M, Coordinate::Theta),
            _ => (Coordinate::Q, Coordinate::Y),
        };
        let response = |step| system.frequency_response(load(tip, load_entry), entry(point(step, false), own));
        for response in (0..tip).filter_map(|step| response(step).ok()) {
            for omega in [0.75, 30.0, 1e4] {
                let (real, complex) = match (response.at(omega), response.at(Complex::new(0.0, omega))) {
                    (Ok(real), Ok(complex)) => (real, complex),
                    // a tree that is held twice in some direction has no motions
                    (real, complex) => {
                        assert!(real.is_err() && complex.is_err(), "seed {seed} at {omega}: {real:?} {complex:?}");
                        let wide = Wide::new(0.0.into(), omega.into());
                        assert!(equations.solve(&tree, wide, tip, load_entry, 1.0).is_none(), "seed {seed} at {omega}");
                        continue;
                    }
                };
                let direct = system.frequency_response(load(tip, load_entry), entry(point(tip, false), own)).unwrap();
                let scale = real.abs().max(direct.at(omega).unwrap().abs());
                let limit = FACTOR * f64::EPSILON * scale;
                assert!((complex - real).norm() <= limit, "seed {seed} at {omega}: {real} {complex}\nvec!{tree:?}");
                compared += 1;
            }
        }
    }
    assert!(compared > 200, "{compared}");
}

/// A single step from a point of a long beam to another, in the far field of its ends: the response of an infinite beam,
/// `-(e^{-βx} + i e^{-iβx})/(4 EI β³)`, where its ends are far and waves decay: `ω` below the real axis.
#[test]
fn a_long_beam_is_an_infinite_one() {
    let (l, ei, m) = (400.0, 2.0, 3.0);
    let beam = |length: f64| ListStep::Element(Part::Beam(Beam { length, bending_stiffness: ei, mass_per_length: m }));
    let body = ListStep::Element(Part::Body(Body { mass: 0.0, inertia: 0.0, output_x: 0.0, centre_x: 0.0 }));
    let distance = 1.5;
    let tip = ListStep::Tip(mstmm::element::Support::Pinned);
    let tree = vec![tip, beam(l), body, beam(distance), beam(l), ListStep::Root(mstmm::element::Support::Free)];
    let system = list_of_tree::undamped::<f64>(&tree);
    let omega = Complex::new(9.0, -0.9);
    let (lambda, beta) = (omega * Complex::<f64>::I, (omega * (m / ei).sqrt()).sqrt());
    let expected = |x: f64| {
        let (decaying, travelling) = ((-beta * x).exp(), (-(beta * Complex::<f64>::I) * x).exp());
        -(decaying + travelling * Complex::<f64>::I) / (beta * beta * beta * (4.0 * ei))
    };
    for (to, x) in [(1, 0.0), (2, 0.0), (3, distance)] {
        let response =
            system.frequency_response(load(2, Coordinate::Q), entry(point(to, false), Coordinate::Y)).unwrap();
        let (actual, expected) = (response.at(lambda).unwrap(), expected(x));
        assert!((actual - expected).norm() < 64.0 * f64::EPSILON * expected.norm(), "{actual} {expected}");
    }
}

//! The dynamic stiffness in double-double arithmetic against closed forms and against finite elements: it judges other
//! tests.
#![expect(clippy::panic, clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::oracles::dynamic_stiffness::{Stiffness, Verdict};
use crate::oracles::finite_elements::Model;
use crate::oracles::legendre_beam::LegendreBeam;
use crate::support::random_tree::{Random, jointed, random_tree};
use crate::support::tree::{Part, Tree};
use core::ops::Range;
use mstmm::Complex;
use mstmm::element::Support;
use mstmm::elements::{Beam, Body, Damper, Mass, PointMass, Spring};
use mstmm::list::ListStep;
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::search::{Eigenvalue, NaturalFrequency};

fn double(value: f64) -> DoubleDouble {
    DoubleDouble::from(value)
}

fn one_beam(tip: Support, root: Support) -> Tree {
    let beam = Beam { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 };
    vec![ListStep::Tip(tip), ListStep::Element(Part::Beam(beam)), ListStep::Root(root)]
}

/// Frequencies `z²` at zeros of a function of z between multiples of π, by bisection to the last bit.
fn frequency(
    function: impl Fn(DoubleDouble) -> DoubleDouble,
    mut lower: DoubleDouble,
    mut upper: DoubleDouble,
) -> DoubleDouble {
    let zero = double(0.0);
    let start = function(lower) > zero;
    for _ in 0..110 {
        let middle = (lower + upper) * double(0.5);
        if (function(middle) > zero) == start { lower = middle } else { upper = middle }
    }
    lower * lower
}

/// Part of a frequency within which its count changes and is sure.
const SHARP: f64 = 1e-27;

/// The count changes within 1e-27 of a frequency.
fn counts_change_at(tip: Support, root: Support, omega: DoubleDouble, below: u64) {
    let model = Stiffness::of(&one_beam(tip, root));
    let counts = [-SHARP, SHARP].map(|part| model.count_below(omega * DoubleDouble::from_sum(1.0, part)));
    assert_eq!(counts, [Some(below), Some(below + 1)], "{tip:?} {root:?} at {omega}");
    // the nearest zero for complex λ, without bounds
    let start = Complex::new(double(1e-13 * omega.to_f64()), double(omega.to_f64()));
    let found = model.eigenvalue_near(start, 1e-14 * omega.to_f64()).unwrap();
    let error = found.re.abs().to_f64().max((found.im - omega).abs().to_f64()) / omega.to_f64();
    assert!(error < 1e-28, "{tip:?} {root:?}: {error:e} of {omega}");
}

/// Closed forms: `cos z + 1/ch z = 0`, `cos z - 1/ch z = 0`, `sin z = 0` and `tan z = th z`.
#[test]
fn counts_of_one_beam_change_at_the_closed_form() {
    let pi: DoubleDouble = "3.14159265358979323846264338327950288".parse().unwrap();
    let inverse_cosh = |z: DoubleDouble| double(1.0) / z.sinh_cosh().1;
    let half = double(0.5);
    for k in 0..12 {
        let from = pi * double(f64::from(k));
        let below = k as u64;
        let cantilever = frequency(|z| z.sin_cos().1 + inverse_cosh(z), from, from + pi);
        counts_change_at(Support::Fixed, Support::Free, cantilever, below);
        counts_change_at(Support::Free, Support::Fixed, cantilever, below);
        let pinned = from + pi;
        counts_change_at(Support::Pinned, Support::Pinned, pinned * pinned, below);
        let from = from + pi;
        let clamped = frequency(|z| z.sin_cos().1 - inverse_cosh(z), from + pi * double(0.3), from + pi * double(0.7));
        counts_change_at(Support::Fixed, Support::Fixed, clamped, below);
        counts_change_at(Support::Free, Support::Free, clamped, below + 2);
        let propped = |z: DoubleDouble| {
            let ((sin, cos), (sh, ch)) = (z.sin_cos(), z.sinh_cosh());
            (sin * ch - cos * sh) / ch
        };
        counts_change_at(
            Support::Fixed,
            Support::Pinned,
            frequency(propped, from + pi * double(0.1), from + pi * half),
            below,
        );
    }
}

/// Closed form of a guided beam at high and low z: `z = kπ`, and a rigid-body mode.
#[test]
fn counts_hold_over_many_decades() {
    let pi: DoubleDouble = "3.14159265358979323846264338327950288".parse().unwrap();
    for k in [1_u32, 30, 1000, 1_000_000] {
        let z = pi * double(f64::from(k));
        let model = Stiffness::of(&one_beam(Support::Guided, Support::Guided));
        // the argument of the sine has a rounding of its own
        let counts = [-1e-27, 1e-27].map(|part| model.count_below(z * z * DoubleDouble::from_sum(1.0, part)));
        assert_eq!(counts, [Some(u64::from(k)), Some(u64::from(k) + 1)], "{k}");
        let low = double(10.0).to_f64().powi(-(k.ilog10() as i32) - 3);
        assert_eq!(model.count_below(double(low)), Some(1), "{low}");
    }
}

static ELEMENT: std::sync::LazyLock<LegendreBeam> = std::sync::LazyLock::new(|| LegendreBeam::new(40));

/// Relative error of a frequency of finite elements beside its rounding.
const CONVERGED: f64 = 1e-11;

/// Finite elements count as many in random trees, where they are sure of it.
fn compared_counts(seeds: Range<u64>, tree: impl Fn(u64) -> Tree) -> usize {
    let (mut compared, mut unsure) = (0, 0);
    for seed in seeds {
        let tree = tree(seed);
        let model = Stiffness::of(&tree);
        let Some(other) = Model::of(&tree, &ELEMENT) else {
            assert!(model.is_held_twice, "seed {seed}");
            continue;
        };
        assert!(!model.is_held_twice, "seed {seed}");
        if other.check().is_err() {
            continue;
        }
        let end = other.frequency_above(12, 31.0);
        let mut random = Random(seed);
        for _ in 0..10 {
            let omega = end * (0.01 + 0.99 * random.unit());
            let error = CONVERGED + other.rounding(omega);
            let counts = [1.0 - error, 1.0 + error].map(|factor| other.count_below(omega * factor));
            if counts[0] == counts[1] {
                match model.sure_count(omega) {
                    Some(count) => assert_eq!(count, counts[0], "seed {seed}: below {omega}\nvec!{tree:?}"),
                    None => unsure += 1,
                }
                compared += 1;
            }
        }
    }
    assert_eq!(unsure, 0, "{compared} compared");
    compared
}

#[test]
fn counts_of_some_random_trees_are_those_of_finite_elements() {
    let compared = compared_counts(0..30, |seed| random_tree(seed, 6, false));
    assert!(compared > 150, "{compared}");
}

/// With hinges of one freedom and levers.
#[test]
fn counts_of_some_jointed_trees_are_those_of_finite_elements() {
    let compared = compared_counts(0..60, |seed| jointed(&random_tree(seed, 4, false), seed));
    assert!(compared > 150, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn counts_of_random_trees_are_those_of_finite_elements() {
    let compared = compared_counts(0..400, |seed| random_tree(seed, 6, false));
    assert!(compared > 2000, "{compared}");
}

/// The counts of two trees change at the same frequencies, to 1e-20 of them.
fn are_one(tree: &Tree, other: &Tree) {
    let [first, second] = [tree, other].map(Stiffness::of);
    let mut upper = double(1e-6);
    for below in 0..8 {
        while first.count_below(upper).unwrap() <= below {
            upper *= double(1.3);
        }
        let mut lower = upper * double(0.5);
        assert!(first.count_below(lower).unwrap() <= below);
        let mut end = upper;
        for _ in 0..70 {
            let middle = (lower + end) * double(0.5);
            if first.count_below(middle).unwrap() > below { end = middle } else { lower = middle }
        }
        let counts = [-1e-20, 1e-20].map(|part| second.count_below(end * DoubleDouble::from_sum(1.0, part)));
        assert_eq!(counts, [Some(below), Some(below + 1)], "{end} of {other:?}");
    }
}

/// Levers there and back are none; a heavy body whose inertia is that of a point is one at the end of a massless lever.
#[test]
fn levers_are_what_they_are_instead() {
    let path = |middle: &[Part]| {
        let beam = |length| Part::Beam(Beam { length, bending_stiffness: 1.3, mass_per_length: 0.7 });
        let parts = [&[beam(1.372)], middle, &[beam(0.911)]].concat();
        let mut tree = vec![ListStep::Tip(Support::Fixed)];
        tree.extend(parts.into_iter().map(ListStep::Element));
        tree.push(ListStep::Root(Support::Free));
        tree
    };
    let body = |mass, inertia, output_x, centre_x| Part::Body(Body { mass, inertia, output_x, centre_x });
    for offset in [1.885, 1885.0, 1.885e6, 1.885e10] {
        let none = path(&[body(1.694, 1.003, 0.0, 0.0)]);
        are_one(&none, &path(&[body(1.694, 1.003, offset, 0.0), body(0.0, 0.0, -offset, 0.0)]));
    }
    for mass in [1.0, 1024.0, 1048576.0, 1073741824.0] {
        // a product without rounding
        let point = path(&[body(mass, mass * 1.125 * 1.125, 0.5, 1.125)]);
        let at_end = Part::PointMass(PointMass { mass, inertia: 0.0 });
        are_one(&point, &path(&[body(0.0, 0.0, 1.125, 0.0), at_end, body(0.0, 0.0, 0.5 - 1.125, 0.0)]));
    }
}

fn disc(lambda: Complex<f64>, error: f64, multiplicity: u64) -> Eigenvalue {
    Eigenvalue { lambda, error, multiplicity, ..Eigenvalue::default() }
}

/// Eigenvalues of finite elements are near, but the discs of a well-known one hold it, and miss it beside it.
#[test]
fn discs_are_judged_by_the_closed_form() {
    let cantilever = Stiffness::of(&one_beam(Support::Fixed, Support::Free));
    let omega = 3.516_015_268_500_151_2;
    let at = |re: f64, im: f64, error: f64| cantilever.judge_discs(&[disc(Complex::new(re, im), error, 1)])[0];
    assert_eq!(at(0.0, omega, 2e-15), Verdict::Holds);
    assert_eq!(at(1e-15, omega, 2e-15), Verdict::Holds);
    for (re, im) in [(1e-12, 0.0), (-1e-12, 0.0), (0.0, 1e-12), (0.0, -1e-12)] {
        let Verdict::Misses(radii) = at(re, omega + im, 1e-14) else { panic!("{re} {im}") };
        assert!((radii - 100.0).abs() < 0.2, "{radii}");
    }
    // `λ = -ζω ± iω sqrt(1 - ζ²)` with ω = 5, ζ = 0.6
    let parts = [Part::Spring(Spring { stiffness: 50.0 }), Part::Damper(Damper { damping: 12.0 })];
    let path = |part| vec![ListStep::Tip(Support::Fixed), ListStep::Element(part)];
    let mut tree: Tree = parts.into_iter().flat_map(path).collect();
    let mass = ListStep::Element(Part::Mass(Mass { mass: 2.0 }));
    tree.extend([ListStep::Connection(2), mass, ListStep::Root(Support::Free)]);
    let model = Stiffness::of(&tree);
    assert_eq!(model.judge_discs(&[disc(Complex::new(-3.0, 4.0), 1e-20, 1)]), [Verdict::Holds]);
    // two that coincide, `λ = -5` with ζ = 1
    let critical: Vec<_> = tree
        .iter()
        .map(|step| match step {
            ListStep::Element(Part::Damper(_)) => ListStep::Element(Part::Damper(Damper { damping: 20.0 })),
            other => *other,
        })
        .collect();
    let model = Stiffness::of(&critical);
    assert_eq!(model.judge_discs(&[disc(Complex::new(-5.0, 0.0), 1e-9, 2)]), [Verdict::Holds]);
    assert_eq!(model.judge_discs(&[disc(Complex::new(-5.0, 1e-8), 1e-9, 2)]), [Verdict::Misses(16.0)]);
}

#[test]
fn intervals_are_judged_by_the_closed_form() {
    let cantilever = Stiffness::of(&one_beam(Support::Fixed, Support::Free));
    let omega = 3.516_015_268_500_151_2;
    let interval = |omega: f64, half: f64| NaturalFrequency {
        omega,
        lower: omega - half,
        upper: omega + half,
        multiplicity: 1,
        ..NaturalFrequency::default()
    };
    assert_eq!(cantilever.judge_intervals(&[interval(omega, 1e-15)], 0), [Verdict::Holds]);
    assert_eq!(cantilever.judge_intervals(&[interval(omega + 3e-14, 1e-14)], 0), [Verdict::Misses(4.0)]);
    assert_eq!(cantilever.judge_intervals(&[interval(omega - 3e-14, 1e-14)], 0), [Verdict::Misses(4.0)]);
    // the second frequency is 18.5 higher
    assert_eq!(cantilever.judge_intervals(&[interval(omega, 1e-14)], 1), [Verdict::Misses(2f64.powi(51))]);
    let bound = cantilever.judge_intervals(&[interval(22.0, 1.0)], 1);
    assert_eq!(bound, [Verdict::Holds]);
}

/// Eigenvalues of the finite elements lie within their error of those of the dynamic stiffness, of which none is missed.
fn compared_eigenvalues(seeds: Range<u64>) -> usize {
    let (mut compared, mut unsure) = (0, 0);
    for seed in seeds {
        let tree = random_tree(seed, 2, true);
        let Some(other) = Model::of(&tree, &ELEMENT) else { continue };
        if other.check().is_err() {
            continue;
        }
        let model = Stiffness::of(&tree);
        let values = other.eigenvalues();
        let near = |a: &Complex<f64>, b: &Complex<f64>| (a - b).norm() < 1e-3 * a.norm();
        for &lambda in values.iter().filter(|a| values.iter().filter(|b| near(a, b)).count() == 1) {
            let error = 10.0 * (CONVERGED + other.rounding(lambda.norm()));
            match model.judge_discs(&[disc(lambda, error * lambda.norm(), 1)])[0] {
                Verdict::Holds => compared += 1,
                Verdict::CannotTell => unsure += 1,
                Verdict::Misses(radii) => panic!("seed {seed}: {lambda} is {radii} radii off\nvec!{tree:?}"),
            }
        }
    }
    assert_eq!(unsure, 0, "{compared} compared");
    compared
}

#[test]
fn eigenvalues_of_some_random_trees_are_those_of_finite_elements() {
    let compared = compared_eigenvalues(0..15);
    assert!(compared > 30, "{compared}");
}

#[test]
#[ignore = "long: .ci/long"]
fn eigenvalues_of_random_trees_are_those_of_finite_elements() {
    let compared = compared_eigenvalues(0..150);
    assert!(compared > 300, "{compared}");
}

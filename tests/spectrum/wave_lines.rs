//! Strings, rods and shafts: closed forms, and random trees of them against their dynamic stiffness and finite elements.
#![expect(clippy::unwrap_used, reason = "a failing helper fails the test that called it")]

use crate::oracles::wave_lines::{Link, Web};
use crate::support::random_tree::Random;
use core::f64::consts::PI;
use mstmm::element::Support;
use mstmm::elements::{Inertia, Mass, Rod, Shaft, Spring, TautString, TorsionSpring};
use mstmm::list::{AnyUndamped, ListStep, StepList};
use mstmm::number::{DoubleDouble, Parameter, Scalar};
use mstmm::prelude::*;

system! {
    /// A string between two walls on an elastic foundation.
    struct Strung { length: f64, tension: f64, m: f64, k: f64 }
    fixed -> string 1 { length, tension, mass_per_length: m, foundation_stiffness: k } -> fixed
}

system! {
    /// A pile in soil with a mass on it.
    struct Pile { length: f64, ea: f64, m: f64, k: f64, mass: f64 }
    fixed -> rod 1 { length, axial_stiffness: ea, mass_per_length: m, foundation_stiffness: k } -> mass 2 { mass } -> free
}

system! {
    /// A free shaft between two disks.
    struct Drive { length: f64, gj: f64, j: f64, first: f64, second: f64 }
    free -> inertia 1 { inertia: first } -> shaft 2 { length, torsional_stiffness: gj, inertia_per_length: j } -> inertia 3 { inertia: second } -> free
}

system! {
    /// A cantilever whose tip hangs on a string.
    struct Hung { l: f64, tension: f64 }
    fixed -> beam 1 { length: 1.0, bending_stiffness: 1.0, mass_per_length: 1.0 } -> conn 2
          -> string 3 { length: l, tension, mass_per_length: 0.7, foundation_stiffness: 0.0 } -> fixed
}

system! {
    /// A string that ends in a dashpot.
    struct Dashed { tension: f64, c: f64 }
    fixed -> string 1 { length: 2.0, tension, mass_per_length: 0.5, foundation_stiffness: 0.0 } -> conn 2 -> free;
    fixed -> damper 3 { damping: c } -> conn 2;
}

fn wide(value: f64) -> DoubleDouble {
    DoubleDouble::from_f64(value)
}

/// Whether a certified interval holds an exact value, and its middle is that to some eps.
#[track_caller]
fn assert_root(found: &NaturalFrequency, exact: DoubleDouble) {
    assert_eq!(found.multiplicity, 1);
    assert!(wide(found.lower) <= exact && exact <= wide(found.upper), "{exact} outside of {found:?}");
    let error = ((wide(found.omega) - exact) / exact).to_f64().abs();
    assert!(error <= 8.0 * f64::EPSILON, "{error:e} at {exact}");
}

fn pi() -> DoubleDouble {
    "3.14159265358979323846264338327950288".parse().unwrap()
}

/// Zeros of a function of the phase up to some value, between samples.
fn zeros(function: impl Fn(DoubleDouble) -> DoubleDouble, end: f64) -> Vec<DoubleDouble> {
    let samples: Vec<f64> = (1..=(200.0 * end) as u32).map(|k| f64::from(k) / 200.0).collect();
    let mut found = Vec::new();
    for pair in samples.windows(2) {
        let [mut lower, mut upper] = [pair[0], pair[1]].map(wide);
        let is_negative = function(lower).is_negative();
        if is_negative == function(upper).is_negative() {
            continue;
        }
        for _ in 0..110 {
            let middle = (lower + upper) * wide(0.5);
            if function(middle).is_negative() == is_negative { lower = middle } else { upper = middle }
        }
        found.push(lower);
    }
    found
}

/// Closed form: `mω² = k + H (nπ/l)²`, beside the cut-on and far above it.
#[test]
fn a_string_between_walls() {
    let (length, tension, m) = (1.7, 320.0, 0.013);
    for k in [0.0, 1e-3, 900.0, 1e9] {
        let system = Strung { length, tension, m, k }.build().unwrap();
        let exact = |n: u32| {
            let number = wide(f64::from(n)) * pi() / wide(length);
            ((wide(k) + wide(tension) * number * number) / wide(m)).sqrt()
        };
        let found = system.first_frequencies::<12>().unwrap();
        assert_eq!(found.len(), 12);
        for (root, n) in found.iter().zip(1..) {
            assert_root(root, exact(n));
        }
        for n in [100, 1000] {
            let [below, above] = [-0.4, 0.4].map(|part| exact(n).to_f64() + part * (exact(n + 1) - exact(n)).to_f64());
            let found = system.natural_frequencies::<4>(below..=above).unwrap();
            assert_eq!(found.len(), 1, "mode {n} on {k}");
            assert_root(&found[0], exact(n));
            assert_eq!(system.count_below(above), Ok(u64::from(n)));
        }
        assert_eq!(system.count_below(0.999 * exact(1).to_f64()), Ok(0));
    }
}

/// Closed form: `φ/tan φ = (M/ml) ψ²` with `ψ² = φ² + k l²/EA`, the square of the frequency.
#[test]
fn a_pile_with_a_mass() {
    let (length, ea, m, mass) = (12.0, 3.1e9, 900.0, 4.0e3);
    for k in [0.0, 2.0e6, 7.0e8] {
        let soil = wide(k) * wide(length) * wide(length) / wide(ea);
        let share = wide(mass) / (wide(m) * wide(length));
        let condition = |phase: DoubleDouble| {
            let (sin, cos) = phase.sin_cos();
            phase * cos - share * (phase * phase + soil) * sin
        };
        // where the mass is heavy for the soil the lowest motion decays along the pile
        let decays = |phase: DoubleDouble| {
            let (sinh, cosh) = phase.sinh_cosh();
            phase * cosh - share * (soil - phase * phase) * sinh
        };
        let speed = wide(ea) / (wide(m) * wide(length) * wide(length));
        let low = zeros(decays, 20.0).into_iter().map(|phase| (soil - phase * phase, true));
        let high = zeros(condition, 60.0).into_iter().map(|phase| (soil + phase * phase, false));
        let found = Pile { length, ea, m, k, mass }.build().unwrap().first_frequencies::<15>().unwrap();
        assert_eq!(low.clone().count(), usize::from(k > 1e8), "the pile of {k} should decay once, below the cut-on");
        for (root, (square, _)) in found.iter().zip(low.chain(high)) {
            assert_root(root, (square * speed).sqrt());
        }
    }
}

/// Closed form: `(αβφ² - 1) sin φ = (α + β) φ cos φ` with the shares α, β of the disks.
#[test]
fn a_shaft_between_disks() {
    let (length, gj, j) = (0.8, 5.2e4, 0.011);
    for (first, second) in [(0.02, 0.3), (1e-4, 1e-4), (5.0, 0.0)] {
        let [a, b] = [first, second].map(|disk| wide(disk) / (wide(j) * wide(length)));
        let condition = |phase: DoubleDouble| {
            let (sin, cos) = phase.sin_cos();
            (a * b * phase * phase - wide(1.0)) * sin - (a + b) * phase * cos
        };
        let speed = (wide(gj) / wide(j)).sqrt() / wide(length);
        let found = Drive { length, gj, j, first, second }.build().unwrap().first_frequencies::<15>().unwrap();
        assert_eq!((found[0].omega, found[0].multiplicity), (0.0, 1));
        for (root, phase) in found[1..].iter().zip(zeros(condition, 60.0)) {
            assert_root(root, phase * speed);
        }
    }
}

/// Closed form: the stiffness of the tip, `EIβ³ (1 + cos z cosh z)/(sin z cosh z - cos z sinh z)`, and of the string, `(H/l) φ cot φ`, add up to
/// zero.
#[test]
fn a_cantilever_on_a_string() {
    for (l, tension) in [(0.5, 3.0), (1.9, 0.2)] {
        let condition = |z: DoubleDouble| {
            let ((sin, cos), (sinh, cosh)) = (z.sin_cos(), z.sinh_cosh());
            let phase = z * z * (wide(0.7) / wide(tension)).sqrt() * wide(l);
            let (string_sin, string_cos) = phase.sin_cos();
            let beam = z * z * z * (wide(1.0) + cos * cosh) * string_sin;
            (beam + wide(tension) / wide(l) * phase * string_cos * (sin * cosh - cos * sinh)) / (cosh * cosh)
        };
        let found = Hung { l, tension }.build().unwrap().first_frequencies::<20>().unwrap();
        for (root, z) in found.iter().zip(zeros(condition, 14.0)) {
            assert_root(root, z * z);
        }
    }
}

/// Closed form: `e^{2λl/v} = (η - 1)/(η + 1)` with `η = c/√(Hm)`.
#[test]
fn a_string_with_a_dashpot() {
    for c in [0.2, 0.9, 1.3, 40.0] {
        let (tension, length): (f64, f64) = (2.0, 2.0);
        let speed = (tension / 0.5).sqrt();
        let ratio = (c - 1.0) / (c + 1.0_f64);
        let system = Dashed { tension, c }.build().unwrap();
        let end = 20.0;
        let found = system.eigenvalues::<64>(Region { re: -5.0..=1.0, im: -1.0..=end }).unwrap();
        let first = if ratio < 0.0 { 0.5 * PI } else { 0.0 };
        let exact = (0..).map(|n| Complex::new(0.5 * ratio.abs().ln(), first + PI * f64::from(n)) * (speed / length));
        let exact: Vec<_> = exact.take_while(|lambda| lambda.im < end).collect();
        let upper: Vec<_> = found.iter().filter(|root| root.lambda.im > -0.1).collect();
        assert_eq!(upper.len(), exact.len(), "{found:?}");
        for lambda in exact {
            let nearest = upper.iter().map(|root| (root.lambda - lambda).norm()).fold(f64::INFINITY, f64::min);
            assert!(nearest <= 64.0 * f64::EPSILON * lambda.norm().max(1.0), "{nearest:e} from {lambda}");
        }
    }
}

/// A random tree of lines, springs and masses, for the library and for the oracle.
struct Grown {
    random: Random,
    is_rotation: bool,
    steps: Vec<ListStep<AnyUndamped<f64>>>,
    web: Web,
    lines: usize,
}

impl Grown {
    fn value(&mut self) -> f64 {
        let decade = if self.random.chance(0.2) { 3.0 } else { 0.7 };
        10f64.powf(decade * (2.0 * self.random.unit() - 1.0))
    }

    fn support(&mut self) -> Support {
        if self.random.chance(0.5) { Support::Fixed } else { Support::Free }
    }

    /// A new point, or the ground at a fixed support.
    fn point(&mut self, is_ground: bool) -> usize {
        if is_ground {
            return 0;
        }
        self.web.masses.push(0.0);
        self.web.masses.len()
    }

    /// An element from one point to another, or beside it.
    fn element(&mut self, element: AnyUndamped<f64>) {
        self.steps.push(ListStep::Element(element));
    }

    /// A path that starts at a tip and ends at a new point behind some elements.
    fn path(&mut self, depth: usize) -> usize {
        let tip = self.support();
        self.steps.push(ListStep::Tip(tip));
        let mut end = self.point(tip == Support::Fixed);
        for _ in 0..=self.random.below(2) {
            end = self.link(end);
            if self.random.chance(0.4) {
                self.mass(end);
            }
        }
        if depth > 0 && self.random.chance(0.5) {
            // the branch ends in a point of its own, which is the same
            let other = self.path(depth - 1);
            self.steps.push(ListStep::Connection(2));
            self.unite(end, other);
        }
        end
    }

    /// A line, or sometimes a spring, from a point to a new one.
    fn link(&mut self, from: usize) -> usize {
        let to = self.point(false);
        if self.random.chance(0.25) {
            let stiffness = self.value();
            self.web.links.push(([from, to], Link::Spring(stiffness)));
            let spring =
                if self.is_rotation { TorsionSpring { stiffness }.try_into() } else { Spring { stiffness }.try_into() };
            self.element(spring.unwrap());
            return to;
        }
        self.lines += 1;
        let [length, stiffness, inertia] = [self.value(), self.value(), self.value()];
        let is_founded = !self.is_rotation && self.random.chance(0.6);
        let foundation_stiffness = if is_founded { 10.0 * self.value() } else { 0.0 };
        self.web.links.push(([from, to], Link::Line([length, stiffness, inertia, foundation_stiffness])));
        let line = if self.is_rotation {
            Shaft { length, torsional_stiffness: stiffness, inertia_per_length: inertia }.try_into()
        } else if self.random.chance(0.5) {
            TautString { length, tension: stiffness, mass_per_length: inertia, foundation_stiffness }.try_into()
        } else {
            Rod { length, axial_stiffness: stiffness, mass_per_length: inertia, foundation_stiffness }.try_into()
        };
        self.element(line.unwrap());
        to
    }

    fn mass(&mut self, at: usize) {
        let mass = self.value();
        self.web.masses[at - 1] += mass;
        let lump = if self.is_rotation { Inertia { inertia: mass }.try_into() } else { Mass { mass }.try_into() };
        self.element(lump.unwrap());
    }

    /// Makes one point of two; the second one is left without links.
    fn unite(&mut self, one: usize, other: usize) {
        for (ends, _) in &mut self.web.links {
            for end in ends {
                *end = if *end == other { one } else { *end };
            }
        }
        self.web.masses[one - 1] += core::mem::take(&mut self.web.masses[other - 1]);
    }

    /// Leaves out points without links, and holds the root if it is fixed.
    fn finish(&mut self, root: usize) {
        let support = self.support();
        self.steps.push(ListStep::Root(support));
        let held = if support == Support::Fixed { root } else { 0 };
        let is_used = |point: usize| self.web.links.iter().any(|(ends, _)| ends.contains(&point)) && point != held;
        let used: Vec<usize> = (1..=self.web.masses.len()).filter(|point| is_used(*point)).collect();
        let place = |point: usize| used.iter().position(|other| *other == point).map_or(0, |place| place + 1);
        let masses = used.iter().map(|point| self.web.masses[point - 1]).collect();
        let links = self.web.links.iter().map(|(ends, link)| (ends.map(place), *link)).collect();
        self.web = Web { masses, links };
    }
}

/// Random trees of each test.
const TREES: usize = 400;

/// Trees with a line at least, so that there are infinitely many frequencies.
fn trees(seed: u64, count: usize) -> impl Iterator<Item = (u64, Grown)> {
    let grown = |seed: u64| {
        let mut grown = Grown {
            random: Random(seed.wrapping_mul(0x9e37_79b9)),
            is_rotation: seed % 4 == 3,
            steps: Vec::new(),
            web: Web::default(),
            lines: 0,
        };
        let root = grown.path(2);
        grown.finish(root);
        (grown.lines > 0 && grown.lines <= 5).then_some((seed, grown))
    };
    (seed..).filter_map(grown).take(count)
}

impl Grown {
    /// A frequency below which there are about so many others.
    fn frequency_above(&self, count: u64) -> f64 {
        let (mut lower, mut upper) = (0.0, 1e4);
        for _ in 0..40 {
            let middle = if upper > 4.0 * lower { 0.3 * upper } else { (lower + upper) / 2.0 };
            if self.web.count_below(wide(middle)) > count { upper = middle } else { lower = middle }
        }
        upper
    }
}

/// Oracle: the dynamic stiffness, and that against polynomials, which know neither waves nor half waves.
#[test]
fn counts_of_random_trees() {
    let mut compared = 0;
    for (seed, mut tree) in trees(1, TREES) {
        let list = StepList::new(&tree.steps).unwrap();
        let end = tree.frequency_above(14);
        for _ in 0..6 {
            let omega = end * (1e-3 + tree.random.unit());
            let expected = tree.web.count_below(wide(omega));
            assert_eq!(list.count_below(omega), Ok(expected), "seed {seed} at {omega}: {:?}", tree.web);
        }
        let omega = end * (0.02 + 0.98 * tree.random.unit());
        if seed % 5 == 0 && tree.web.longest(omega) < 30.0 {
            compared += 1;
            let [exact, elements] = [tree.web.count_below(wide(omega)), tree.web.count_of_elements(omega, 40)];
            assert_eq!(exact, elements, "seed {seed} at {omega}: {:?}", tree.web);
        }
    }
    assert!(compared > TREES / 12, "{compared} of {TREES}");
}

/// Oracle: the dynamic stiffness at the ends of each certified interval.
#[test]
fn frequencies_of_random_trees() {
    for (seed, tree) in trees(1000, TREES) {
        let list = StepList::new(&tree.steps).unwrap();
        let end = tree.frequency_above(12);
        let found = list.natural_frequencies::<64>(0.0..=end);
        let Ok(found) = found else { panic!("seed {seed}: {found:?} {:?}", tree.web) };
        let mut below = 0;
        for root in &found {
            if root.omega > 0.0 {
                // next to a pole of a line the oracle loses digits, which the interval has not room for
                let room = root.omega * 4.0 * f64::EPSILON;
                let counts = [root.lower - room, root.upper + room].map(|omega| tree.web.count_below(wide(omega)));
                assert_eq!(counts, [below, below + root.multiplicity], "seed {seed} {root:?}: {:?}", tree.web);
            }
            below += root.multiplicity;
        }
        let total = tree.web.count_below(wide(end));
        assert!(
            below == total || found.last().is_some_and(|root| root.upper >= end),
            "seed {seed}: {below} of {total}"
        );
    }
}

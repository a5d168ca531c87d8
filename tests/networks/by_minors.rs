//! The same model by minors of planes, as a list of steps, and by stiffnesses, as a network.

use crate::checks::Found;
use crate::structure::{Element, Structure};
use crate::support::list_of_tree::undamped_steps;
use crate::support::random_tree::random_tree;
use crate::support::tree::{Part, Tree, chain};
use crate::through_library::{characteristic, count, first};
use crate::tree_as_network::network_of;
use mstmm::list::{ListStep, StepList};
use mstmm::number::{DoubleDouble, Parameter, Scalar, Scaled};
use mstmm::prelude::*;

/// What hardly stretches: the first frequencies along members are far above those of bending.
const RIGID: f64 = 1e10;

/// What stretches a little: the exact factor of a member that is held along its axis tells how much.
const STIFF: f64 = 16_777_216.0;

/// Part of a quotient of two Δ in twice the digits that rounding is: of each variable of the members, as large as what hardly stretches is
/// stiff.
fn rounding(structure: &Structure) -> f64 {
    (6 * structure.members.len()) as f64 * DoubleDouble::EPSILON * STIFF
}

const OMEGAS: [f64; 6] = [0.037, 0.31, 1.9, 7.3, 41.0, 190.0];

/// A random tree whose lengths are multiples of 1/64, so that sums of them are exact.
fn tree_on_a_grid(seed: u64) -> Tree {
    let mut tree = random_tree(seed, 4, false);
    for step in &mut tree {
        match step {
            ListStep::Element(Part::Beam(beam)) => {
                beam.length = on_grid(beam.length);
                // the wave number per root of the frequency is a power of two, which no product of parameters rounds
                beam.bending_stiffness = beam.mass_per_length * if beam.bending_stiffness < 1.0 { 1.0 } else { 16.0 };
            }
            ListStep::Element(Part::Body(body)) => {
                (body.mass, body.output_x, body.centre_x) =
                    (on_grid(body.mass), on_grid(body.output_x), on_grid(body.centre_x));
                body.inertia = on_grid(body.inertia) + body.mass * body.centre_x * body.centre_x;
            }
            _ => {}
        }
    }
    tree
}

fn on_grid(length: f64) -> f64 {
    (64.0 * length).ceil() / 64.0
}

#[derive(Debug, Default)]
struct Report {
    trees: usize,
    refused: usize,
    refused_by_stiffnesses: Vec<String>,
    refused_by_minors: Vec<String>,
    counts: usize,
    roots: usize,
    quotients: usize,
    furthest: f64,
    furthest_name: String,
    largest: f64,
    wrong: Vec<String>,
}

/// `Π sin ζ/ζ` of the members, which are held along their axes at both ends.
fn axial(structure: &Structure, omega: f64) -> DoubleDouble {
    let double = DoubleDouble::from;
    let mut product = double(1.0);
    for member in &structure.members {
        let Element::Beam(section) = member.element else { continue };
        let [from, to] = member.ends.each_ref().map(|end| structure.position(end));
        let [ea, m] = [section.axial_stiffness, section.mass_per_length].map(double);
        let phase = double(omega) * (double(to[0]) - double(from[0])) * (m / ea).sqrt();
        let (sin, _) = phase.sin_cos();
        product = product * sin / phase;
    }
    product
}

fn quotient(one: Scaled<DoubleDouble>, other: Scaled<DoubleDouble>) -> DoubleDouble {
    let shift = (one.exponent() - other.exponent()).clamp(-900, 900);
    (one.mantissa() / other.mantissa()).times_power_of_two(shift as i32)
}

impl Report {
    fn compare(&mut self, name: &str, tree: &Tree) {
        let steps = undamped_steps::<f64>(tree);
        let Ok(list) = StepList::new(&steps) else { return };
        let structure = network_of(tree, RIGID);
        if structure.members.is_empty() {
            return;
        }
        self.trees += 1;
        // what is held twice, by exactly the same, makes Δ vanish at all frequencies: trees hold it once, frames refuse it
        if OMEGAS.into_iter().all(|omega| list.characteristic(DoubleDouble::from(omega)).mantissa().size() == 0.0) {
            match first(&structure) {
                Ok(found) => self.wrong.push(format!("{name}: {found:?} of what is held twice")),
                Err(_) => self.refused += 1,
            }
            return;
        }
        let by_minors = list.first_frequencies::<10>().map(|found| found.to_vec());
        let roots: Vec<f64> = by_minors.iter().flatten().map(|root| root.omega).collect();
        let beside = |omega: f64| roots.iter().map(move |root| (root / omega - 1.0).abs());
        let nearest = OMEGAS.into_iter().flat_map(beside).fold(1.0, f64::min);
        match (by_minors, first(&structure)) {
            (Ok(one), Ok(other)) => self.roots(name, &one, &other),
            // something is held twice, or by nothing: counts are refused or right
            (Err(_), Err(_)) => {
                self.refused += 1;
                return;
            }
            (Ok(_), Err(error)) => self.refused_by_stiffnesses.push(format!("{name}: {error}")),
            (Err(error), Ok(_)) => self.refused_by_minors.push(format!("{name}: {error}")),
        }
        for omega in OMEGAS {
            match (list.count_below(omega), count(&structure, omega)) {
                (Ok(one), Ok(other)) if one == other => self.counts += 1,
                (Err(_), Err(_)) => {}
                (one, other) => self.wrong.push(format!("{name}: {one:?}, {other:?} below {omega}")),
            }
        }
        let stretched = network_of(tree, STIFF);
        match characteristic(&stretched, &OMEGAS) {
            Err(error) => self.wrong.push(format!("{name}: {error}")),
            Ok(values) => {
                let ratio = |(omega, value): (f64, Scaled<DoubleDouble>)| {
                    quotient(value, list.characteristic(DoubleDouble::from(omega))) / axial(&stretched, omega)
                };
                let ratios: Vec<DoubleDouble> = OMEGAS.into_iter().zip(values).map(ratio).collect();
                self.quotients(name, &ratios, rounding(&stretched) / nearest);
            }
        }
    }

    fn roots(&mut self, name: &str, one: &[NaturalFrequency], other: &[Found]) {
        let one = one.iter().flat_map(|root| (0..root.multiplicity).map(|_| (root.omega, root.lower, root.upper)));
        let other = other.iter().flat_map(|root| (0..root.multiplicity).map(|_| (root.omega, root.lower, root.upper)));
        for (one, other) in one.zip(other) {
            self.roots += 1;
            let distance = if one.0 == other.0 { 0.0 } else { (one.0 - other.0).abs() / (one.0 * f64::EPSILON) };
            if distance > self.furthest {
                (self.furthest, self.furthest_name) = (distance, format!("{name}: {one:?}, {other:?}"));
            }
            if one.1 > other.2 || other.1 > one.2 {
                self.wrong.push(format!("{name}: {one:?}, {other:?} are {distance} eps apart"));
            }
        }
    }

    /// Quotients of Δ are constant up to an error, which grows next to roots.
    fn quotients(&mut self, name: &str, ratios: &[DoubleDouble], error: f64) {
        for ratio in ratios {
            let difference = (*ratio / ratios[0] - DoubleDouble::from(1.0)).to_f64().abs();
            self.quotients += 1;
            self.largest = self.largest.max(difference);
            // a NaN is not constant
            if difference.is_nan() || difference > error {
                self.wrong.push(format!("{name}: Δ differs by {difference:e}"));
            }
        }
    }

    fn judge(self) {
        let Report {
            trees,
            refused,
            refused_by_stiffnesses,
            refused_by_minors,
            counts,
            roots,
            quotients,
            furthest,
            furthest_name,
            largest,
            wrong,
        } = self;
        println!(
            "{trees} trees, {refused} refused by both, {counts} counts, {roots} roots up to {furthest:.1} eps apart"
        );
        println!("  furthest {furthest_name}");
        println!("  {quotients} quotients of Δ, constant up to {largest:e}");
        refused_by_stiffnesses.iter().for_each(|why| println!("  refused by stiffnesses alone: {why}"));
        refused_by_minors.iter().for_each(|why| println!("  refused by minors alone: {why}"));
        wrong.iter().for_each(|why| println!("  wrong {why}"));
        assert!(wrong.is_empty(), "{} wrong", wrong.len());
        assert!(refused_by_stiffnesses.is_empty(), "{} of {trees} refused", refused_by_stiffnesses.len());
    }
}

fn judge(seeds: core::ops::Range<u64>) {
    let mut report = Report::default();
    seeds.for_each(|seed| report.compare(&format!("random_tree({seed}, 4)"), &tree_on_a_grid(seed)));
    for masses in [3, 30] {
        report.compare(&format!("chain({masses})"), &chain(masses, 7.0, 0.3));
    }
    report.judge();
}

#[test]
fn trees_by_charts_are_trees_by_minors() {
    judge(0..10);
}

#[test]
#[ignore = "many trees: in .ci/long"]
fn many_trees_by_charts_are_trees_by_minors() {
    judge(0..2000);
}

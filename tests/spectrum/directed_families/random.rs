//! Random trees, undirected: their parameters over a few decades or many.

use super::searches::{counts_up_to, first_eigenvalues, first_frequencies};
use super::tally::Tally;
use crate::oracles::dynamic_stiffness::Stiffness;
use crate::support::random_tree::{Random, random_tree};
use crate::support::tree::{Part, Tree};
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Lever, Mass, PointMass, RotationalHinge, ShearHinge, Spring,
    SpringDamper, TorsionDamper, TorsionSpring, TorsionSpringDamper,
};
use mstmm::list::ListStep;

/// Part of the bodies that are points on arms.
const POINTS: f64 = 0.3;

/// A part whose parameters are moved by up to so many decades each.
fn stretched(part: Part, random: &mut Random, decades: f64) -> Part {
    let is_point = random.unit() < POINTS;
    let mut by = |value: f64| value * 10f64.powf(decades * (2.0 * random.unit() - 1.0));
    match part {
        Part::Beam(b) => Part::Beam(Beam {
            length: by(b.length),
            bending_stiffness: by(b.bending_stiffness),
            mass_per_length: by(b.mass_per_length),
        }),
        Part::Body(b) => {
            let central = by(b.inertia - b.mass * b.centre_x * b.centre_x);
            let (mass, centre_x, output_x) = (by(b.mass), by(b.centre_x), by(b.output_x));
            let inertia = mass * centre_x * centre_x + if is_point { 0.0 } else { central };
            Part::Body(Body { mass, inertia, output_x, centre_x })
        }
        Part::ElasticHinge(h) => {
            Part::ElasticHinge(ElasticHinge { stiffness_y: by(h.stiffness_y), stiffness_theta: by(h.stiffness_theta) })
        }
        Part::RotationalHinge(h) => Part::RotationalHinge(RotationalHinge { stiffness: by(h.stiffness) }),
        Part::ShearHinge(h) => Part::ShearHinge(ShearHinge { stiffness: by(h.stiffness) }),
        Part::Lever(l) => Part::Lever(Lever { output_x: by(l.output_x) }),
        Part::PointMass(p) => Part::PointMass(PointMass { mass: by(p.mass), inertia: by(p.inertia) }),
        Part::Spring(s) => Part::Spring(Spring { stiffness: by(s.stiffness) }),
        Part::TorsionSpring(s) => Part::TorsionSpring(TorsionSpring { stiffness: by(s.stiffness) }),
        Part::Mass(p) => Part::Mass(Mass { mass: by(p.mass) }),
        Part::Inertia(p) => Part::Inertia(Inertia { inertia: by(p.inertia) }),
        Part::Damper(d) => Part::Damper(Damper { damping: by(d.damping) }),
        Part::TorsionDamper(d) => Part::TorsionDamper(TorsionDamper { damping: by(d.damping) }),
        Part::SpringDamper(s) => {
            Part::SpringDamper(SpringDamper { stiffness: by(s.stiffness), damping: by(s.damping) })
        }
        Part::TorsionSpringDamper(s) => {
            Part::TorsionSpringDamper(TorsionSpringDamper { stiffness: by(s.stiffness), damping: by(s.damping) })
        }
    }
}

fn tree(seed: u64, beams: usize, damped: bool, decades: f64) -> Tree {
    let random = &mut Random(seed ^ 0x5eed);
    let part = |step: &ListStep<Part>| match *step {
        ListStep::Element(part) => ListStep::Element(stretched(part, random, decades)),
        other => other,
    };
    random_tree(seed, beams, damped).iter().map(part).collect()
}

/// Sums over sound models, and over those that hold something twice or hold nothing: what is said of these is right, or
/// an error.
#[derive(Default)]
pub(crate) struct Sums {
    pub(crate) sound: Tally,
    pub(crate) degenerate: Tally,
}

impl Sums {
    fn of(&mut self, model: &Stiffness) -> &mut Tally {
        let tally = if model.is_sound() { &mut self.sound } else { &mut self.degenerate };
        tally.models += 1;
        tally
    }
}

/// Discs of damped trees.
pub(crate) fn damped(seeds: impl IntoIterator<Item = u64>, decades: f64) -> Sums {
    let mut sums = Sums::default();
    for tree in seeds.into_iter().map(|seed| tree(seed, 3, true, decades)) {
        let model = Stiffness::of(&tree);
        first_eigenvalues::<6>(&tree, &model, sums.of(&model));
    }
    sums
}

/// Intervals and counts of undamped trees.
pub(crate) fn undamped(seeds: impl IntoIterator<Item = u64>, decades: f64) -> Sums {
    let mut sums = Sums::default();
    for seed in seeds {
        let tree = tree(seed, 6, false, decades);
        let model = Stiffness::of(&tree);
        let tally = sums.of(&model);
        first_frequencies::<6>(&tree, &model, tally);
        counts_up_to(&tree, 10.0, &mut Random(seed), &model, tally);
    }
    sums
}

//! Parts of the models of families, and random numbers for them.

use crate::support::random_tree::Random;
use crate::support::tree::{Part, Tree};
use mstmm::element::Support;
use mstmm::elements::{Beam, Body, Damper, ElasticHinge, Mass, Spring, SpringDamper};
use mstmm::list::ListStep;

/// A random number between two, with three decimals: one that is no sum of few powers of two.
pub(crate) fn decimal(random: &mut Random, from: f64, to: f64) -> f64 {
    ((from + (to - from) * random.unit()) * 1000.0).round() / 1000.0
}

/// A random integer below a limit.
pub(crate) fn below(random: &mut Random, limit: usize) -> usize {
    (random.unit() * limit as f64) as usize
}

pub(crate) fn tip(support: Support) -> ListStep<Part> {
    ListStep::Tip(support)
}

pub(crate) fn root(support: Support) -> ListStep<Part> {
    ListStep::Root(support)
}

pub(crate) fn conn(inputs: usize) -> ListStep<Part> {
    ListStep::Connection(inputs)
}

pub(crate) fn beam(length: f64, bending_stiffness: f64, mass_per_length: f64) -> ListStep<Part> {
    ListStep::Element(Part::Beam(Beam { length, bending_stiffness, mass_per_length }))
}

pub(crate) fn body(mass: f64, inertia: f64, output_x: f64, centre_x: f64) -> ListStep<Part> {
    ListStep::Element(Part::Body(Body { mass, inertia, output_x, centre_x }))
}

pub(crate) fn hinge(stiffness_y: f64, stiffness_theta: f64) -> ListStep<Part> {
    ListStep::Element(Part::ElasticHinge(ElasticHinge { stiffness_y, stiffness_theta }))
}

pub(crate) fn spring(stiffness: f64) -> ListStep<Part> {
    ListStep::Element(Part::Spring(Spring { stiffness }))
}

pub(crate) fn damper(damping: f64) -> ListStep<Part> {
    ListStep::Element(Part::Damper(Damper { damping }))
}

pub(crate) fn spring_damper(stiffness: f64, damping: f64) -> ListStep<Part> {
    ListStep::Element(Part::SpringDamper(SpringDamper { stiffness, damping }))
}

pub(crate) fn mass(mass: f64) -> ListStep<Part> {
    ListStep::Element(Part::Mass(Mass { mass }))
}

/// Paths into a connection, in an order, and what is behind it.
pub(crate) fn joint(paths: &[&Tree], behind: &[ListStep<Part>]) -> Tree {
    let mut tree: Tree = paths.iter().flat_map(|path| path.iter().copied()).collect();
    tree.push(conn(paths.len()));
    tree.extend_from_slice(behind);
    tree
}

//! Trees as data: the same description leads to a list of steps of the library and to an independent model.

use mstmm::element::Space;
use mstmm::elements::{
    Beam, Body, Damper, ElasticHinge, Inertia, Mass, PointMass, Spring, SpringDamper, TorsionDamper, TorsionSpring,
    TorsionSpringDamper,
};
use mstmm::list::ListStep;

/// A tree: tips before what they lead to, inputs of a connection before it, the root last.
///
/// The `Debug` text of a tree is, but for paths, the source that builds it.
pub(crate) type Tree = Vec<ListStep<Part>>;

/// An element with its parameters.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Part {
    Beam(Beam<f64>),
    Body(Body<f64>),
    ElasticHinge(ElasticHinge<f64>),
    PointMass(PointMass<f64>),
    Spring(Spring<f64>),
    TorsionSpring(TorsionSpring<f64>),
    Mass(Mass<f64>),
    Inertia(Inertia<f64>),
    Damper(Damper<f64>),
    TorsionDamper(TorsionDamper<f64>),
    SpringDamper(SpringDamper<f64>),
    TorsionSpringDamper(TorsionSpringDamper<f64>),
}

impl Part {
    /// Space of the states at both ends.
    pub(crate) fn space(&self) -> Space {
        match self {
            Part::Beam(_) | Part::Body(_) | Part::ElasticHinge(_) | Part::PointMass(_) => Space::Bending,
            Part::Spring(_) | Part::Mass(_) | Part::Damper(_) | Part::SpringDamper(_) => Space::Translation,
            _ => Space::Rotation,
        }
    }

    /// Stiffness and damping of a link between two displacements of one kind.
    pub(crate) fn link(&self) -> Option<[f64; 2]> {
        match *self {
            Part::Spring(p) => Some([p.stiffness, 0.0]),
            Part::TorsionSpring(p) => Some([p.stiffness, 0.0]),
            Part::Damper(p) => Some([0.0, p.damping]),
            Part::TorsionDamper(p) => Some([0.0, p.damping]),
            Part::SpringDamper(p) => Some([p.stiffness, p.damping]),
            Part::TorsionSpringDamper(p) => Some([p.stiffness, p.damping]),
            _ => None,
        }
    }
}

/// Space of the element to which a step leads, if it leads to one.
pub(crate) fn next_space(tree: &Tree, step: usize) -> Option<Space> {
    match tree.get(step + 1) {
        Some(ListStep::Element(part)) => Some(part.space()),
        _ => None,
    }
}

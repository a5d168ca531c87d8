//! The freedoms of points: each element brings its own.

use super::graph::Graph;
use super::paths::{PathMotion, Paths};
use super::points::Points;
use crate::ast::Element;
use crate::keywords::{Dimension, Role};
use mstmm_plan::Freedoms;
use syn::ext::IdentExt;

/// A set of freedoms: known ones, and those that elements of the user's own bring, as rustc alone knows.
#[derive(Clone)]
pub(crate) struct FreedomSet<'a> {
    pub(crate) known: Freedoms,
    pub(crate) own: Vec<&'a Element>,
    /// The freedoms that elements of the user's own may bring.
    pub(crate) within: Freedoms,
}

impl<'a> FreedomSet<'a> {
    /// A set without elements of the user's own.
    pub(crate) fn known(known: Freedoms) -> Self {
        FreedomSet { known, own: Vec::new(), within: Freedoms::NONE }
    }

    /// The freedom of a path in the axes of its elements: along them or about z.
    pub(crate) fn along(motion: PathMotion<'a>) -> Self {
        let within = Freedoms::X.union(Freedoms::RZ);
        match motion {
            PathMotion::Translation => FreedomSet::known(Freedoms::X),
            PathMotion::Rotation => FreedomSet::known(Freedoms::RZ),
            PathMotion::Of(element) => FreedomSet { own: vec![element], within, ..FreedomSet::known(Freedoms::NONE) },
        }
    }

    /// The set, if elements of the user's own cannot add to it.
    pub(crate) fn as_known(&self) -> Option<Freedoms> {
        (self.own.is_empty() || self.known.contains(self.within)).then_some(self.known)
    }

    /// The freedoms that may be in it.
    pub(crate) fn possible(&self) -> Freedoms {
        if self.own.is_empty() { self.known } else { self.known.union(self.within) }
    }

    /// Adds what a path brings to a point.
    fn bring(&mut self, motion: PathMotion<'a>) {
        match motion {
            PathMotion::Of(element) => self.own.push(element),
            PathMotion::Translation => self.bring_known(Freedoms::DISPLACEMENTS),
            PathMotion::Rotation => self.bring_known(Freedoms::ROTATIONS),
        }
    }

    fn bring_known(&mut self, brought: Freedoms) {
        self.known = self.known.union(brought.intersection(self.within));
    }
}

/// The freedoms of each point, by its representative.
pub(crate) fn freedoms<'a>(
    graph: &Graph<'a>,
    points: &Points,
    paths: &Paths<'a>,
    dimension: Dimension,
) -> Vec<FreedomSet<'a>> {
    let none = FreedomSet { within: dimension.freedoms(), ..FreedomSet::known(Freedoms::NONE) };
    let mut freedoms = vec![none; graph.vertices.len() + graph.edges.len()];
    for (vertex, row) in graph.vertices.iter().enumerate().filter_map(|(index, vertex)| Some((index, vertex.row()?))) {
        match row.role {
            Role::Member | Role::RigidBody | Role::Joint => {
                points.ends(graph, vertex).into_iter().for_each(|point| freedoms[point].bring_known(row.brings));
            }
            Role::PointMass => {
                let turns = graph.vertices[vertex].as_element().is_some_and(has_inertia);
                let inertia = if turns { Freedoms::ROTATIONS } else { Freedoms::NONE };
                freedoms[points.point(vertex)].bring_known(row.brings.union(inertia));
            }
            Role::Connection | Role::Support | Role::Path | Role::Unknown => {}
        }
    }
    for path in &paths.all {
        path.contacts.iter().for_each(|contact| freedoms[contact.point].bring(path.motion));
    }
    freedoms
}

/// Whether a point mass has the inertia that it may have.
fn has_inertia(element: &Element) -> bool {
    element.parameters().any(|parameter| parameter.name.unraw() == "inertia")
}

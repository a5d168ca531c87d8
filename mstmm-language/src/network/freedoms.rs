//! The freedoms of points: each element brings its own.

use super::graph::Graph;
use super::paths::Paths;
use super::points::Points;
use crate::ast::Element;
use crate::keywords::{Dimension, Role};
use mstmm_plan::Freedoms;
use syn::ext::IdentExt;

/// The freedoms of each point, by its representative.
pub(crate) fn freedoms(graph: &Graph<'_>, points: &Points, paths: &Paths, dimension: Dimension) -> Vec<Freedoms> {
    let mut freedoms = vec![Freedoms::NONE; graph.vertices.len() + graph.edges.len()];
    let mut bring = |point: usize, brought: Freedoms| {
        freedoms[point] = freedoms[point].union(brought.intersection(dimension.freedoms()));
    };
    for (vertex, row) in graph.vertices.iter().enumerate().filter_map(|(index, vertex)| Some((index, vertex.row()?))) {
        match row.role {
            Role::Member | Role::RigidBody | Role::Joint => {
                points.ends(graph, vertex).into_iter().for_each(|point| bring(point, row.brings));
            }
            Role::PointMass => {
                let turns = graph.vertices[vertex].as_element().is_some_and(has_inertia);
                let inertia = if turns { Freedoms::RZ } else { Freedoms::NONE };
                bring(points.point(vertex), row.brings.union(inertia));
            }
            Role::Connection | Role::Support | Role::Path | Role::Unknown => {}
        }
    }
    for path in &paths.all {
        path.contacts.iter().for_each(|contact| bring(contact.point, path.freedoms(graph)));
    }
    freedoms
}

/// Whether a point mass has the inertia that it may have.
fn has_inertia(element: &Element) -> bool {
    element.parameters().any(|parameter| parameter.name.unraw() == "inertia")
}

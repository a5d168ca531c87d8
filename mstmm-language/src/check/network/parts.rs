//! A model is one connected structure.

use crate::diagnostics::Errors;
use crate::keywords::Role;
use crate::network::{Classes, Graph};

/// Reports each part of the model that no arrow joins to the first.
pub(super) fn parts(graph: &Graph<'_>, errors: &mut Errors) {
    let mut parts = Classes::new(graph.vertices.len());
    for edge in &graph.edges {
        parts.join(edge.from, edge.to);
    }
    let joined = |vertex: &usize| graph.edges_of(*vertex).next().is_some();
    let firsts = (0..graph.vertices.len()).filter(|&vertex| parts.of(vertex) == vertex).filter(joined);
    for first in firsts.skip(1) {
        let members = || (first..graph.vertices.len()).filter(|&vertex| parts.of(vertex) == first);
        if members().all(|vertex| matches!(graph.role(vertex), Role::Connection | Role::Support)) {
            continue;
        }
        // what is unknown may be a name of something else, by which the part is joined
        if members().any(|vertex| graph.role(vertex) == Role::Unknown) {
            continue;
        }
        let shown = members().find(|&vertex| graph.role(vertex) != Role::Support).unwrap_or(first);
        let vertex = &graph.vertices[shown];
        let message = format!(
            "no path joins `{}` to what is written before it: a model is one structure, so name a connection of it here",
            vertex.name()
        );
        errors.push(vertex.place(), message);
    }
}

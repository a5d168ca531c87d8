//! Rules of the two nodes at one arrow.

use crate::diagnostics::Errors;
use crate::keywords::{Dimension, Role};
use crate::network::{Edge, Graph, Paths, Points};

/// Checks which nodes each arrow joins, and where directions stand.
pub(super) fn arrows(graph: &Graph<'_>, points: &Points, paths: &Paths<'_>, dimension: Dimension, errors: &mut Errors) {
    for (index, edge) in graph.edges.iter().enumerate() {
        if edge.ends().iter().any(|&end| graph.role(end) == Role::Unknown) {
            continue;
        }
        if let Some(message) = fault(graph, points, edge, dimension) {
            errors.push(edge.arrow.place, message);
        } else if let Some(along) = edge.along() {
            let is_contact = paths.all.iter().flat_map(|path| &path.contacts).any(|contact| contact.edge == index);
            if dimension != Dimension::Line && !is_contact {
                let message = format!(
                    "`{}` stands where a path of springs, dampers or masses meets a point with a place: \
                     this arrow joins no such two, so remove it",
                    along.keyword
                );
                errors.push(along.keyword.span(), message);
            }
        }
    }
}

/// What is wrong with the two nodes at an arrow.
fn fault(graph: &Graph<'_>, points: &Points, edge: &Edge<'_>, dimension: Dimension) -> Option<String> {
    let [from, to] = edge.ends().map(|end| graph.role(end));
    let [a, b] = edge.ends().map(|end| graph.vertices[end].name());
    let needs_place = |role: Role| matches!(role, Role::Member | Role::RigidBody);
    let takes_place = |role: Role| role.is_point() || role == Role::Joint;
    match (from, to) {
        (Role::Support, Role::Support) => {
            Some(format!("this arrow joins two supports, `{a}` and `{b}`: put an element between them"))
        }
        (Role::Connection, Role::Connection) if edge.from != edge.to => {
            let have_places = edge.ends().iter().all(|&end| points.is_located(end));
            have_places.then(|| {
                format!("`{a}` and `{b}` have a place each, and an arrow has no extent: put an element between them")
            })
        }
        _ if takes_place(from) || takes_place(to) => None,
        _ if needs_place(from) || needs_place(to) => Some(format!(
            "`{a}` and `{b}` meet at a point that has no place: put a connection between them, `-> conn a {} ->`",
            dimension.example()
        )),
        _ => None,
    }
}

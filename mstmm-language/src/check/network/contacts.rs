//! Rules of paths of translation and rotation, and of the points on which they act.

use super::dimension::counted;
use crate::diagnostics::Errors;
use crate::keywords::{Dimension, Role, support_of};
use crate::network::{Contact, Edge, Graph, Named, Path, Paths, Points};
use mstmm_plan::Support;

/// Checks each path and its contacts with points that have places.
pub(super) fn contacts(graph: &Graph<'_>, points: &Points, paths: &Paths, dimension: Dimension, errors: &mut Errors) {
    for path in paths.all.iter().filter(|path| !is_doubtful(graph, points, path)) {
        if !is_mixed(graph, path, errors) {
            directions(graph, points, path, dimension, errors);
        }
    }
    if dimension == Dimension::Plane {
        loose_points(graph, points, paths, errors);
    }
}

/// Whether a path may have other contacts: one of its ends is missing, a node of unknown meaning stands at it, or a point
/// whose place is missing.
fn is_doubtful(graph: &Graph<'_>, points: &Points, path: &Path) -> bool {
    let edges = path.elements.iter().flat_map(|&element| graph.edges_of(element).map(move |edge| (element, edge)));
    let is_doubtful = |(element, (index, edge)): (usize, (usize, &Edge<'_>))| {
        let end = points.end(graph, index, element);
        graph.role(edge.other(element)) == Role::Unknown || points.is_doubtful(end) || points.lacks_place(end)
    };
    let has_ends = |&element: &usize| graph.edges_of(element).count() == 2;
    edges.into_iter().any(is_doubtful) || !path.elements.iter().all(has_ends)
}

/// Reports elements of translation and of rotation in one path.
fn is_mixed(graph: &Graph<'_>, path: &Path, errors: &mut Errors) -> bool {
    let brings = |element: usize| graph.vertices[element].row().map(|row| row.brings);
    let Some((&first, others)) = path.elements.split_first() else { return false };
    let Some(&other) = others.iter().find(|&&other| brings(other) != brings(first)) else { return false };
    let (turns, moves) = if path.is_rotation(graph) { (first, other) } else { (other, first) };
    let message = format!(
        "`{}` turns and `{}` moves, so they share no motion: join them at a connection with a place",
        graph.vertices[turns].name(),
        graph.vertices[moves].name()
    );
    errors.push(graph.vertices[other].place(), message);
    true
}

/// Checks that the direction of a path is known at each of its contacts.
fn directions(graph: &Graph<'_>, points: &Points, path: &Path, dimension: Dimension, errors: &mut Errors) {
    let edge = |contact: &Contact| &graph.edges[contact.edge];
    if dimension == Dimension::Line {
        return;
    }
    if path.is_rotation(graph) {
        for along in path.contacts.iter().filter_map(|contact| edge(contact).along()) {
            let message = "a path of torsion elements turns about z, the one axis of the plane: remove `along`";
            errors.push(along.keyword.span(), message);
        }
        return;
    }
    let without: Vec<&Contact> = path.contacts.iter().filter(|contact| edge(contact).along().is_none()).collect();
    if without.len() == path.contacts.len() {
        if let Some((contact, message)) = undirected(graph, points, path) {
            errors.push(edge(contact).arrow.place, message);
        }
        return;
    }
    for contact in without {
        let message = format!(
            "this path says `along` where it meets other points: say it here too, {}",
            example(graph, points, contact)
        );
        errors.push(edge(contact).arrow.place, message);
    }
}

/// What is missing where no contact of a path says a direction: exactly two points at two places have a line through them.
fn undirected<'p>(graph: &Graph<'_>, points: &Points, path: &'p Path) -> Option<(&'p Contact, String)> {
    match path.contacts.as_slice() {
        [] => None,
        [contact] => {
            let element = &graph.vertices[path.elements[0]];
            let is_mass = |&vertex: &usize| graph.vertices[vertex].row().is_some_and(|row| row.name == "mass");
            let message = if path.elements.iter().all(is_mass) {
                format!(
                    "`{}` moves in one direction, and none is said: write `point_mass`, which moves in all",
                    element.name()
                )
            } else {
                format!(
                    "the direction of `{}` is unknown, since its path meets one point with a place: say it, {}",
                    element.name(),
                    example(graph, points, contact)
                )
            };
            Some((contact, message))
        }
        [first, second] if points.place(first.point) == points.place(second.point) => Some((
            second,
            "this path begins and ends at one place, through which no line leads: say `along` at both ends".to_owned(),
        )),
        [_, _] => None,
        [.., last] => Some((
            last,
            format!(
                "this path meets {} points with places, and a line leads through two: say `along` at each of them, {}",
                counted(path.contacts.len()),
                example(graph, points, last)
            ),
        )),
    }
}

/// How a direction is written at a contact.
fn example(graph: &Graph<'_>, points: &Points, contact: &Contact) -> String {
    let mut at_point = points.vertices_at(graph, contact.point);
    let name = at_point.find(|&vertex| graph.role(vertex) == Role::Connection);
    let name = name.map_or_else(|| "conn a".to_owned(), |vertex| graph.vertices[vertex].name());
    format!("`{name} <- along (dx, dy) <- ..`")
}

/// Reports points with places that one path alone moves: across it they have neither mass nor stiffness.
fn loose_points(graph: &Graph<'_>, points: &Points, paths: &Paths, errors: &mut Errors) {
    let is_free_end = |&vertex: &usize| {
        leaves_all(graph, vertex)
            && graph.edges_of(vertex).all(|(_, edge)| graph.role(edge.other(vertex)) == Role::Path)
    };
    let free_ends = graph.with_role(Role::Support).filter(is_free_end);
    for vertex in graph.with_role(Role::Connection).chain(free_ends).filter(|&vertex| points.is_located(vertex)) {
        let point = points.point(vertex);
        let moved = paths.all.iter().filter(|path| !path.is_rotation(graph)).flat_map(|path| {
            path.contacts.iter().filter(|contact| contact.point == point).map(move |_| path.elements[0])
        });
        let moved: Vec<usize> = moved.collect();
        let is_alone = graph.edges_of(vertex).all(|(_, edge)| match graph.role(edge.other(vertex)) {
            Role::Path | Role::Connection => true,
            Role::Support => leaves_all(graph, edge.other(vertex)),
            _ => false,
        });
        if let ([element], true, false) = (moved.as_slice(), is_alone, points.is_doubtful(point)) {
            let message = format!(
                "nothing holds `{}` across the path of `{}`: remove its place, so that it moves along the path alone, or \
                 hold it by a support",
                graph.vertices[vertex].name(),
                graph.vertices[*element].name()
            );
            errors.push(graph.vertices[vertex].place(), message);
        }
    }
}

/// Whether a support holds nothing.
fn leaves_all(graph: &Graph<'_>, vertex: usize) -> bool {
    let Named::Support(support) = graph.vertices[vertex].node else { return false };
    support_of(&support.keyword.to_string()) == Some(Support::Free)
}

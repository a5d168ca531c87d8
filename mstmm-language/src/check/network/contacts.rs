//! Rules of paths of translation and rotation, and of the points on which they act.

use super::dimension::counted;
use super::findings::Findings;
use super::in_space;
use crate::ast::Element;
use crate::diagnostics::Place;
use crate::keywords::{ABOUT, Dimension, Role, support_of};
use crate::network::{Contact, Edge, Graph, Named, Path, PathMotion, Paths, Points};
use mstmm_plan::{Space, Support};

/// Checks each path and its contacts with points that have places.
pub(super) fn contacts<'a>(
    graph: &Graph<'a>,
    points: &Points,
    paths: &Paths<'a>,
    dimension: Dimension,
    findings: &mut Findings<'a>,
) {
    for path in paths.all.iter().filter(|path| !is_doubtful(graph, points, path)) {
        if !is_mixed(graph, path, findings) && dimension != Dimension::Line {
            directions(graph, points, path, dimension, findings);
        }
    }
    match dimension {
        Dimension::Line => {}
        Dimension::Plane => loose_points(graph, points, paths, findings),
        Dimension::Space => in_space::loose_points(graph, points, paths, findings),
    }
}

/// Whether a path may have other contacts: one of its ends is missing, a node of unknown meaning stands at it, or a point
/// whose place is missing.
fn is_doubtful(graph: &Graph<'_>, points: &Points, path: &Path<'_>) -> bool {
    let edges = path.elements.iter().flat_map(|&element| graph.edges_of(element).map(move |edge| (element, edge)));
    let is_doubtful = |(element, (index, edge)): (usize, (usize, &Edge<'_>))| {
        let end = points.end(graph, index, element);
        graph.role(edge.other(element)) == Role::Unknown || points.is_doubtful(end) || points.lacks_place(end)
    };
    let has_ends = |&element: &usize| graph.edges_of(element).count() == 2;
    edges.into_iter().any(is_doubtful) || !path.elements.iter().all(has_ends)
}

/// Reports elements of translation and of rotation in one path.
fn is_mixed<'a>(graph: &Graph<'a>, path: &Path<'a>, findings: &mut Findings<'a>) -> bool {
    let brings = |element: usize| graph.vertices[element].row().map(|row| row.brings);
    let known = path.elements.iter().copied().find(|&element| brings(element).is_some());
    let Some(first) = known.or(path.elements.first().copied()) else { return false };
    let mut is_mixed = false;
    for &other in path.elements.iter().filter(|&&other| other != first) {
        let moves_first = format_mixed(graph, other, first);
        let turns_first = format_mixed(graph, first, other);
        let place = graph.vertices[other].place();
        let Some(own) = graph.vertices[other].as_element().filter(|_| brings(other).is_none()) else {
            if !is_mixed && brings(other) != brings(first) {
                is_mixed = true;
                let turns = matches!(path.motion, PathMotion::Rotation);
                findings.error(place, if turns { turns_first } else { moves_first });
            }
            continue;
        };
        match path.motion {
            PathMotion::Translation => findings.suspect(place, moves_first, [(own, Space::Rotation)]),
            PathMotion::Rotation => findings.suspect(place, turns_first, [(own, Space::Translation)]),
            PathMotion::Of(first) => {
                findings.suspect(place, turns_first, [(first, Space::Rotation), (own, Space::Translation)]);
                findings.suspect(place, moves_first, [(first, Space::Translation), (own, Space::Rotation)]);
            }
        }
    }
    is_mixed
}

/// The message for an element that turns in a path with one that moves.
fn format_mixed(graph: &Graph<'_>, turns: usize, moves: usize) -> String {
    format!(
        "`{}` turns and `{}` moves, so they share no motion: join them at a connection with a place",
        graph.vertices[turns].name(),
        graph.vertices[moves].name()
    )
}

/// Checks that the direction of a path is known at each of its contacts if it moves. Of one that turns the axis is known, or in the plane none is said.
fn directions<'a>(
    graph: &Graph<'a>,
    points: &Points,
    path: &Path<'a>,
    dimension: Dimension,
    findings: &mut Findings<'a>,
) {
    let moves = || if dimension == Dimension::Space { turning(graph, path) } else { Vec::new() };
    let undirected = || match moves() {
        wrong if wrong.is_empty() => undirected(graph, points, path, dimension),
        wrong => wrong,
    };
    let directed = || match dimension {
        Dimension::Space => without_axis(graph, points, path),
        Dimension::Line | Dimension::Plane => directed(graph, path),
    };
    match path.motion {
        PathMotion::Translation => findings.errors_of(undirected()),
        PathMotion::Rotation => findings.errors_of(directed()),
        PathMotion::Of(element) => {
            findings.suspect_all(undirected(), (element, Space::Translation));
            findings.suspect_all(directed(), (element, Space::Rotation));
        }
    }
}

/// What is wrong with axes of rotation of a path that moves.
fn turning(graph: &Graph<'_>, path: &Path<'_>) -> Vec<(Place, String)> {
    let said = path.contacts.iter().filter_map(|contact| graph.edges[contact.edge].along());
    let about = said.filter(|direction| direction.keyword == ABOUT);
    let message = "a path that moves acts along a direction: write `along` in the place of `about`";
    about.map(|about| (about.keyword.span().into(), message.to_owned())).collect()
}

/// What is wrong with axes of a path that turns, in space: it has one at each of its contacts.
fn without_axis(graph: &Graph<'_>, points: &Points, path: &Path<'_>) -> Vec<(Place, String)> {
    let of_contact = |contact: &Contact| {
        let edge = &graph.edges[contact.edge];
        let place = match edge.along() {
            Some(about) if about.keyword == ABOUT => return None,
            Some(along) => along.keyword.span().into(),
            None => edge.arrow.place,
        };
        let example = contact_name(graph, points, contact);
        Some((place, format!("a path that turns acts about an axis: `{example} <- about (0.0, 0.0, 1.0) <- ..`")))
    };
    path.contacts.iter().filter_map(of_contact).collect()
}

/// What is wrong with directions of a path that turns, in the plane.
fn directed(graph: &Graph<'_>, path: &Path<'_>) -> Vec<(Place, String)> {
    let said = path.contacts.iter().filter_map(|contact| graph.edges[contact.edge].along());
    // of `about` a message of its own speaks
    let along = said.filter(|direction| direction.keyword != ABOUT);
    let message = "a path of torsion elements turns about z, the one axis of the plane: remove `along`";
    along.map(|along| (along.keyword.span().into(), message.to_owned())).collect()
}

/// What is wrong with directions of a path that moves: it has one at each of its contacts, or at none.
fn undirected(graph: &Graph<'_>, points: &Points, path: &Path<'_>, dimension: Dimension) -> Vec<(Place, String)> {
    let edge = |contact: &Contact| &graph.edges[contact.edge];
    let without: Vec<&Contact> = path.contacts.iter().filter(|contact| edge(contact).along().is_none()).collect();
    if without.len() == path.contacts.len() {
        let missing = without_line(graph, points, path, dimension);
        return missing.into_iter().map(|(contact, message)| (edge(contact).arrow.place, message)).collect();
    }
    let message = |contact: &Contact| {
        let example = example(graph, points, contact, dimension);
        format!("this path says `along` where it meets other points: say it here too, {example}")
    };
    without.into_iter().map(|contact| (edge(contact).arrow.place, message(contact))).collect()
}

/// What is missing where no contact of a path says a direction: exactly two points at two places have a line through them.
fn without_line<'p>(
    graph: &Graph<'_>,
    points: &Points,
    path: &'p Path<'_>,
    dimension: Dimension,
) -> Option<(&'p Contact, String)> {
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
                    example(graph, points, contact, dimension)
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
                example(graph, points, last, dimension)
            ),
        )),
    }
}

/// How a direction is written at a contact.
fn example(graph: &Graph<'_>, points: &Points, contact: &Contact, dimension: Dimension) -> String {
    format!("`{} <- along {} <- ..`", contact_name(graph, points, contact), dimension.direction())
}

/// The connection at a contact.
fn contact_name(graph: &Graph<'_>, points: &Points, contact: &Contact) -> String {
    let mut at_point = points.vertices_at(graph, contact.point);
    let name = at_point.find(|&vertex| graph.role(vertex) == Role::Connection);
    name.map_or_else(|| "conn a".to_owned(), |vertex| graph.vertices[vertex].name())
}

/// Reports points with places that one path alone moves: across it they have neither mass nor stiffness.
fn loose_points<'a>(graph: &Graph<'a>, points: &Points, paths: &Paths<'a>, findings: &mut Findings<'a>) {
    let is_free_end = |&vertex: &usize| {
        leaves_all(graph, vertex)
            && graph.edges_of(vertex).all(|(_, edge)| graph.role(edge.other(vertex)) == Role::Path)
    };
    let free_ends = graph.with_role(Role::Support).filter(is_free_end);
    for vertex in graph.with_role(Role::Connection).chain(free_ends).filter(|&vertex| points.is_located(vertex)) {
        let point = points.point(vertex);
        let is_alone = graph.edges_of(vertex).all(|(_, edge)| match graph.role(edge.other(vertex)) {
            Role::Path | Role::Connection => true,
            Role::Support => leaves_all(graph, edge.other(vertex)),
            _ => false,
        });
        if !is_alone || points.is_doubtful(point) {
            continue;
        }
        for (path, of) in alone_at(paths, point) {
            let message = format!(
                "nothing holds `{}` across the path of `{}`: remove its place, so that it moves along the path alone, or \
                 hold it by a support",
                graph.vertices[vertex].name(),
                graph.vertices[path.elements[0]].name()
            );
            findings.suspect(graph.vertices[vertex].place(), message, of);
        }
    }
}

/// The paths that may be the only one that moves a point, each with what elements of the user's own then do.
fn alone_at<'p, 'a>(paths: &'p Paths<'a>, point: usize) -> Vec<(&'p Path<'a>, Vec<(&'a Element, Space)>)> {
    let at_point = paths
        .all
        .iter()
        .flat_map(|path| path.contacts.iter().filter(|contact| contact.point == point).map(move |_| path));
    let moving: Vec<&Path<'_>> = at_point.filter(|path| !matches!(path.motion, PathMotion::Rotation)).collect();
    let alone = |index: usize| {
        let mut of = Vec::new();
        for (other, path) in moving.iter().enumerate() {
            match path.motion {
                PathMotion::Of(element) if other == index => of.push((element, Space::Translation)),
                PathMotion::Of(element) => of.push((element, Space::Rotation)),
                PathMotion::Translation | PathMotion::Rotation if other == index => {}
                PathMotion::Translation | PathMotion::Rotation => return None,
            }
        }
        Some((moving[index], of))
    };
    (0..moving.len()).filter_map(alone).collect()
}

/// Whether a support holds nothing.
fn leaves_all(graph: &Graph<'_>, vertex: usize) -> bool {
    let Named::Support(support) = graph.vertices[vertex].node else { return false };
    support_of(&support.keyword.to_string()) == Some(Support::Free)
}

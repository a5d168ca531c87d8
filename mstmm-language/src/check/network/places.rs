//! Rules of places: a point where an element with extent ends has one, and no point has two.

use crate::diagnostics::Errors;
use crate::keywords::{Dimension, Role};
use crate::network::{Graph, Location, Points};

/// Checks that each place is said once, that those are said which elements need, and that elements lead from one to another.
pub(super) fn places(graph: &Graph<'_>, points: &Points, dimension: Dimension, errors: &mut Errors) {
    said_twice(graph, points, errors);
    nowhere_else(graph, points, errors);
    let mut places: Vec<usize> = points.all(graph).into_iter().map(|point| points.place(point)).collect();
    places.sort_unstable();
    places.dedup();
    for place in places.into_iter().filter(|&place| points.lacks_place(place) && !points.is_doubtful(place)) {
        never_said(graph, points, place, dimension, errors);
    }
}

/// Reports each `at` of a place beyond the one that stands behind a connection, or else beyond the first.
fn said_twice(graph: &Graph<'_>, points: &Points, errors: &mut Errors) {
    let is_connection = |location: &&Location<'_>| graph.role(location.vertex) == Role::Connection;
    for location in &graph.locations {
        let at_this_place = || {
            let place = points.place(location.vertex);
            graph.locations.iter().filter(move |other| points.place(other.vertex) == place)
        };
        let Some(owner) = at_this_place().find(is_connection).or_else(|| at_this_place().next()) else { continue };
        let is_owner = std::ptr::eq(owner.at, location.at);
        if held_connection(graph, points, location.vertex).is_some() || !is_owner {
            let (place, message) = (location.at.keyword.span(), said_before(graph, points, location, owner));
            errors.push(place, message);
            if location.vertex == owner.vertex && !is_owner {
                let message = format!("the place of `{}` is said here first", graph.vertices[owner.vertex].name());
                errors.push(owner.at.keyword.span(), message);
            }
        }
    }
}

/// The connection that a support holds.
fn held_connection(graph: &Graph<'_>, points: &Points, support: usize) -> Option<usize> {
    let is_connection = |vertex: &usize| graph.role(*vertex) == Role::Connection;
    let point = points.point(support);
    (graph.role(support) == Role::Support).then(|| points.vertices_at(graph, point).find(is_connection)).flatten()
}

/// Why a place is not said at a location.
fn said_before(graph: &Graph<'_>, points: &Points, location: &Location<'_>, owner: &Location<'_>) -> String {
    let name = |vertex: usize| graph.vertices[vertex].name();
    let this = name(location.vertex);
    if let Some(connection) = held_connection(graph, points, location.vertex) {
        let connection = name(connection);
        return format!(
            "`{this}` is at the place of `{connection}`, which it holds: write `at` behind `{connection}` alone"
        );
    }
    if location.vertex == owner.vertex {
        return format!(
            "the place of `{this}` is said already: `at` stands at one mention of a point, so remove this one"
        );
    }
    let joint = graph.edges_of(location.vertex).map(|(_, edge)| edge.other(location.vertex));
    let joint = joint.into_iter().find(|&vertex| graph.role(vertex) == Role::Joint);
    let reason = joint.map_or_else(String::new, |joint| format!(", since `{}` has no extent", name(joint)));
    format!("`{this}` is at the place of `{}`{reason}: remove this `at`", name(owner.vertex))
}

/// Reports elements whose two ends are one.
fn nowhere_else(graph: &Graph<'_>, points: &Points, errors: &mut Errors) {
    for (index, vertex) in graph.vertices.iter().enumerate() {
        let ends = points.ends(graph, index);
        let &[first, second] = ends.as_slice() else { continue };
        let (is_one_point, is_one_place) = (first == second, points.place(first) == points.place(second));
        let message = match vertex.role {
            Role::Member if is_one_place => "begins and ends at one place: lead it from one point to another",
            Role::Joint if is_one_point => "joins a point to itself: give its other side a connection of its own",
            Role::Path if is_one_point && !points.is_located(first) => {
                "joins a point to itself: lead it from one point to another"
            }
            _ => continue,
        };
        errors.push(vertex.place(), format!("`{}` {message}", vertex.name()));
    }
}

/// Reports a place that an element needs and no `at` says, at the first node to which one can be written.
fn never_said(graph: &Graph<'_>, points: &Points, place: usize, dimension: Dimension, errors: &mut Errors) {
    let stands_here = |&vertex: &usize| match graph.role(vertex) {
        role if role.is_point() => points.place(vertex) == place,
        Role::Unknown => false,
        _ => points.ends(graph, vertex).iter().any(|&end| points.place(end) == place),
    };
    let first =
        |roles: &[Role]| roles.iter().find_map(|&role| graph.with_role(role).find(|vertex| stands_here(vertex)));
    let Some(user) = first(&[Role::Member, Role::RigidBody, Role::PointMass, Role::Joint]) else { return };
    let Some(target) = first(&[Role::Connection, Role::Support, Role::Joint, Role::PointMass]) else { return };
    let (here, needs) = (graph.vertices[target].name(), graph.vertices[user].name());
    let example = dimension.example();
    if graph.role(user) == Role::PointMass && first(&[Role::Path]).is_some() {
        let message =
            format!("`{needs}` stands in a path, whose points have no places: write `mass` there, not `point_mass`");
        return errors.push(graph.vertices[user].place(), message);
    }
    let located = graph.edges_of(target).map(|(_, edge)| edge.other(target)).find(|&other| {
        (graph.role(target), graph.role(other)) == (Role::Connection, Role::Connection) && points.is_located(other)
    });
    let message = match (graph.role(target), located) {
        (_, Some(located)) => format!(
            "`{here}` is at the place of `{0}`, since an arrow has no extent: write `{0}` in both paths",
            graph.vertices[located].name()
        ),
        (Role::Connection | Role::Support, None) => {
            format!("`{here}` has no place, which `{needs}` needs there: write `{here} {example}`")
        }
        _ => format!("`{here}` stands at no place: put a connection beside it, `-> conn a {example} -> {here}`"),
    };
    errors.push(graph.vertices[target].place(), message);
}

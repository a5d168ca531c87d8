//! Rules of models in space alone: parameters of both planes of a member, and points that paths alone move.

use super::findings::Findings;
use crate::ast::Element;
use crate::diagnostics::Errors;
use crate::keywords::{Dimension, PAIRS, Role, freedom_of, in_space, support_of};
use crate::network::{Graph, Named, PathMotion, Paths, Points};
use mstmm_plan::{Freedoms, Support};
use syn::ext::IdentExt;

/// The parameters that an element must have, and those that it may have, given those of its keyword: what it names for one plane it needs for the
/// other one, too, if it must be named.
pub(super) fn known(element: &Element, [mut required, mut optional]: [Vec<&'static str>; 2]) -> [Vec<&'static str>; 2] {
    if element.dimension != Dimension::Space {
        return [required, optional];
    }
    for pair in PAIRS {
        let is_required = required.contains(&pair.both);
        // of a name for both planes beside one for a single plane a message of its own speaks
        if is_required && !element.gives(pair.both) && pair.planes.iter().any(|plane| element.gives(plane)) {
            required.retain(|name| *name != pair.both);
            required.extend(pair.planes);
            optional.retain(|name| !pair.planes.contains(name));
        }
    }
    [required, optional]
}

/// Reports parameters that are named for both planes and for one of them.
pub(super) fn named_twice(element: &Element, errors: &mut Errors) {
    let keyword = element.kind.name().to_string();
    if element.dimension != Dimension::Space || !in_space(&keyword).is_some_and(|row| row.has_planes) {
        return;
    }
    for pair in PAIRS.iter().filter(|pair| element.gives(pair.both)) {
        let second = element
            .parameters()
            .filter(|parameter| !parameter.is_told)
            .find(|parameter| pair.planes.iter().any(|name| parameter.name.unraw() == name));
        if let Some(second) = second {
            let message = format!(
                "`{element}` gives `{0}` for both planes, and `{1}` for one: remove one of the two",
                pair.both, second.name
            );
            errors.push(second.name.span(), message);
        }
    }
}

/// Reports points with places that paths alone move, and fewer of them than a point in space has displacements, or rotations.
pub(super) fn loose_points<'a>(graph: &Graph<'a>, points: &Points, paths: &Paths<'a>, findings: &mut Findings<'a>) {
    for point in points.all(graph).into_iter().filter(|&point| points.is_located(point) && !points.is_doubtful(point)) {
        let vertices: Vec<usize> = points.vertices_at(graph, point).collect();
        let is_moved_by_paths = |&vertex: &usize| {
            matches!(graph.role(vertex), Role::Connection | Role::Support)
                && graph.edges_of(vertex).all(|(_, edge)| {
                    matches!(graph.role(edge.other(vertex)), Role::Path | Role::Connection | Role::Support)
                })
        };
        if vertices.is_empty() || !vertices.iter().all(is_moved_by_paths) {
            continue;
        }
        let here = paths.all.iter().flat_map(|path| path.contacts.iter().map(move |contact| (path, contact)));
        let motions: Vec<PathMotion<'_>> =
            here.filter(|(_, contact)| contact.point == point).map(|(path, _)| path.motion).collect();
        if motions.iter().any(|motion| matches!(motion, PathMotion::Of(_))) {
            continue;
        }
        let held = vertices.iter().map(|&vertex| held_at(graph, vertex)).fold(Freedoms::NONE, Freedoms::union);
        for (turns, all) in [(false, Freedoms::DISPLACEMENTS), (true, Freedoms::ROTATIONS)] {
            let acting = motions.iter().filter(|motion| matches!(motion, PathMotion::Rotation) == turns).count();
            if acting > 0 && acting + held.intersection(all).count() < 3 {
                let (what, all) = if turns { ("turns", "axes") } else { ("moves", "directions") };
                let message = format!(
                    "`{}` {what} freely in {all} of which no path is: hold it, give it members or mass, or leave it without a place",
                    graph.vertices[vertices[0]].name()
                );
                findings.error(graph.vertices[vertices[0]].place(), message);
            }
        }
    }
}

/// The freedoms that a vertex holds if it is a support.
fn held_at(graph: &Graph<'_>, vertex: usize) -> Freedoms {
    let Named::Support(support) = graph.vertices[vertex].node else { return Freedoms::NONE };
    if let Some(held) = &support.held {
        let held = held.iter().filter_map(|name| freedom_of(&name.unraw().to_string()));
        return held.fold(Freedoms::NONE, Freedoms::union);
    }
    match support_of(&support.keyword.to_string()) {
        Some(Support::Free) | None => Freedoms::NONE,
        Some(Support::Pinned) => Freedoms::DISPLACEMENTS,
        // of a skew one numbers decide
        Some(_) => Freedoms::SPACE,
    }
}

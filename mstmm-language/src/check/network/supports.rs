//! Rules of supports: one at a point, which holds what the point has.

use super::findings::Findings;
use crate::keywords::{Dimension, Role, freedom_of, support_of};
use crate::network::{FreedomSet, Graph, Named, Points};
use mstmm_plan::{Freedoms, Space, Support};
use syn::ext::IdentExt;

/// Checks the supports of each point.
///
/// `freedoms` are those that elements bring to each point.
pub(super) fn supports<'a>(
    graph: &Graph<'a>,
    points: &Points,
    freedoms: &[FreedomSet<'a>],
    dimension: Dimension,
    findings: &mut Findings<'a>,
) {
    for point in points.all(graph) {
        let mut supports = points.vertices_at(graph, point).filter(|&vertex| graph.role(vertex) == Role::Support);
        let Some(first) = supports.next() else { continue };
        for second in supports {
            let message = format!(
                "`{}` is a second support of {}, which `{}` holds: one support says all that is held, such as `held(x, rz)`",
                graph.vertices[second].name(),
                name(graph, points, point),
                graph.vertices[first].name()
            );
            findings.error(graph.vertices[second].place(), message);
        }
        if !points.is_doubtful(point) {
            support(graph, points, first, (&freedoms[point], dimension), findings);
        }
    }
}

/// The connection at a point, or whatever else stands there.
fn name(graph: &Graph<'_>, points: &Points, point: usize) -> String {
    let mut all = points.vertices_at(graph, point).filter(|&vertex| graph.role(vertex) == Role::Connection);
    all.next().map_or_else(|| "this point".to_owned(), |vertex| format!("`{}`", graph.vertices[vertex].name()))
}

/// Checks one support against the freedoms that its point has.
fn support<'a>(
    graph: &Graph<'a>,
    points: &Points,
    vertex: usize,
    (has, dimension): (&FreedomSet<'a>, Dimension),
    findings: &mut Findings<'a>,
) {
    let Named::Support(support) = graph.vertices[vertex].node else { return };
    let point = points.point(vertex);
    if !points.is_located(point) {
        let is_in_path = points.vertices_at(graph, point).any(|vertex| touches_path(graph, vertex));
        let of_path = matches!(support_of(&support.keyword.to_string()), Some(Support::Fixed | Support::Free));
        if is_in_path && !of_path {
            let message = format!(
                "`{}` is no support of a path of springs, dampers and masses: its one motion is held by `fixed`, or `free`",
                support.keyword
            );
            findings.error(support.keyword.span(), message);
        }
        return;
    }
    // a point that no element moves has another message
    let all = if has.possible().is_empty() { Freedoms::NONE } else { dimension.freedoms() };
    let lacks = all.without(has.known);
    for held in support.held.iter().flatten() {
        let Some(freedom) = freedom_of(&held.unraw().to_string()).filter(|freedom| lacks.contains(*freedom)) else {
            continue;
        };
        let message = format!("no element at {} has the freedom `{held}`: remove it", name(graph, points, point));
        let other = if Freedoms::ROTATIONS.contains(freedom) { Space::Translation } else { Space::Rotation };
        findings.suspect(held.span(), message, has.own.iter().map(|&own| (own, other)));
    }
}

fn touches_path(graph: &Graph<'_>, vertex: usize) -> bool {
    graph.edges_of(vertex).any(|(_, edge)| graph.role(edge.other(vertex)) == Role::Path)
}

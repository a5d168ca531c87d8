//! Paths of translation and of rotation: elements and points without places that share one motion each.

use super::classes::Classes;
use super::graph::Graph;
use super::points::Points;
use crate::ast::Element;
use crate::keywords::Role;
use mstmm_plan::Freedoms;

/// The one motion of a path.
#[derive(Clone, Copy)]
pub(crate) enum PathMotion<'a> {
    /// Along a direction.
    Translation,
    /// About z.
    Rotation,
    /// That of its first element, where all are the user's own: rustc alone knows it.
    Of(&'a Element),
}

/// A path: what hangs together without a place in between.
pub(crate) struct Path<'a> {
    pub(crate) motion: PathMotion<'a>,
    /// Its elements, by their vertices in source order.
    pub(crate) elements: Vec<usize>,
    /// Where it acts on points with places, in source order.
    pub(crate) contacts: Vec<Contact>,
}

/// The arrow at which a path acts on a point with a place.
#[derive(Clone, Copy)]
pub(crate) struct Contact {
    pub(crate) edge: usize,
    /// The point with the place.
    pub(crate) point: usize,
    /// The motion of the path there.
    pub(crate) node: usize,
}

/// The paths of a network.
pub(crate) struct Paths<'a> {
    pub(crate) all: Vec<Path<'a>>,
    /// Points without places that move as one.
    nodes: Classes,
}

impl<'a> Paths<'a> {
    pub(crate) fn of(graph: &Graph<'a>, points: &Points) -> Self {
        let count = graph.vertices.len() + graph.edges.len();
        let (mut nodes, mut together) = (Classes::new(count), Classes::new(count));
        for point in 0..count {
            nodes.join(point, points.point(point));
        }
        for (from, to) in linked(graph, points) {
            nodes.join(from, to);
        }
        let mut this = Paths { all: Vec::new(), nodes };
        for element in graph.with_role(Role::Path) {
            for (edge, _) in graph.edges_of(element) {
                together.join(element, this.node(graph, points, edge, element));
            }
        }
        let mut classes: Vec<usize> = graph.with_role(Role::Path).map(|element| together.of(element)).collect();
        classes.sort_unstable();
        classes.dedup();
        let contacts = contacts(graph, points, &this);
        for class in classes {
            let elements: Vec<usize> =
                graph.with_role(Role::Path).filter(|&element| together.of(element) == class).collect();
            this.all.push(Path {
                motion: motion(graph, &elements),
                elements,
                contacts: contacts.iter().filter(|contact| together.of(contact.node) == class).copied().collect(),
            });
        }
        this
    }

    /// The motion of a path at the end of an element that an edge leads to: its own at a point with a place.
    pub(crate) fn node(&self, graph: &Graph<'_>, points: &Points, edge: usize, element: usize) -> usize {
        let end = points.end(graph, edge, element);
        if points.is_located(end) { points.of_edge(edge) } else { self.nodes.of(end) }
    }

    /// The motion of a point without a place.
    pub(crate) fn node_of_point(&self, point: usize) -> usize {
        self.nodes.of(point)
    }
}

/// The motion of elements that hang together: that of the first whose keyword says it.
fn motion<'a>(graph: &Graph<'a>, elements: &[usize]) -> PathMotion<'a> {
    let of_keyword = |&element: &usize| graph.vertices[element].row().map(|row| row.brings);
    let own = elements.first().and_then(|&first| graph.vertices[first].as_element());
    match (elements.iter().find_map(of_keyword), own) {
        (Some(Freedoms::ROTATIONS), _) => PathMotion::Rotation,
        (None, Some(element)) => PathMotion::Of(element),
        _ => PathMotion::Translation,
    }
}

/// Connections without places that an arrow joins.
fn linked(graph: &Graph<'_>, points: &Points) -> Vec<(usize, usize)> {
    let is_loose = |vertex: &usize| graph.role(*vertex) == Role::Connection && !points.is_located(*vertex);
    let edges = graph.edges.iter().filter(|edge| edge.ends().iter().all(is_loose));
    edges.map(|edge| (points.point(edge.from), points.point(edge.to))).collect()
}

/// All contacts in source order: ends of elements at points with places, and arrows between a connection with a place and
/// one without.
fn contacts(graph: &Graph<'_>, points: &Points, paths: &Paths<'_>) -> Vec<Contact> {
    let mut contacts = Vec::new();
    for (index, edge) in graph.edges.iter().enumerate() {
        for [near, far] in [[edge.from, edge.to], [edge.to, edge.from]] {
            let (role, other) = (graph.role(near), graph.role(far));
            if role == Role::Path {
                let point = points.end(graph, index, near);
                if points.is_located(point) {
                    contacts.push(Contact { edge: index, point, node: points.of_edge(index) });
                }
            } else if (role, other) == (Role::Connection, Role::Connection)
                && !points.is_located(near)
                && points.is_located(far)
            {
                contacts.push(Contact {
                    edge: index,
                    point: points.point(far),
                    node: paths.node_of_point(points.point(near)),
                });
            }
        }
    }
    contacts
}

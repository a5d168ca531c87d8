//! The points of a network, and which of them are at one place.
//!
//! A connection, a support and a point mass that arrows join are one point, and so is the end of an element there. Between two
//! elements an arrow is a point of its own. A joint has points on either side, which are at one place.

use super::classes::Classes;
use super::graph::Graph;
use crate::keywords::Role;
use std::collections::BTreeSet;

/// Points by their representatives: a vertex that is a point by its index, the point of an arrow by that behind the vertices.
pub(crate) struct Points {
    vertices: usize,
    points: Classes,
    places: Classes,
    /// Places with an `at`.
    located: BTreeSet<usize>,
    /// Places that an element needs: one with extent, a joint, a mass at a point.
    needed: BTreeSet<usize>,
    /// Places at which a node of unknown meaning stands: what they lack is not reported.
    doubtful: BTreeSet<usize>,
}

impl Points {
    pub(crate) fn of(graph: &Graph<'_>) -> Self {
        let count = graph.vertices.len();
        let mut points = Classes::new(count + graph.edges.len());
        for edge in &graph.edges {
            let [from, to] = edge.ends().map(|vertex| graph.role(vertex));
            // two connections are two points, and of two supports `check` says that nothing is between them
            if from.is_point() && to.is_point() && (from != to || from == Role::PointMass) {
                points.join(edge.from, edge.to);
            }
        }
        let [located, needed, doubtful] = [(); 3].map(|()| BTreeSet::new());
        let mut this = Points { vertices: count, places: points.clone(), points, located, needed, doubtful };
        for joint in graph.with_role(Role::Joint) {
            let ends = this.ends(graph, joint);
            ends.windows(2).for_each(|pair| this.places.join(pair[0], pair[1]));
        }
        this.located = graph.locations.iter().map(|location| this.place(location.vertex)).collect();
        this.doubtful = this.places_of(graph, &[Role::Unknown]);
        this.needed = this.places_of(graph, &[Role::Member, Role::RigidBody, Role::Joint]);
        let masses: Vec<usize> = graph.with_role(Role::PointMass).map(|mass| this.place(mass)).collect();
        this.needed.extend(masses);
        this
    }

    /// The places at which elements of some roles have their ends.
    fn places_of(&self, graph: &Graph<'_>, roles: &[Role]) -> BTreeSet<usize> {
        let elements = roles.iter().flat_map(|&role| graph.with_role(role));
        elements.flat_map(|element| self.ends(graph, element)).map(|end| self.place(end)).collect()
    }

    /// The point at which an element has the end that an edge leads to.
    pub(crate) fn end(&self, graph: &Graph<'_>, edge: usize, element: usize) -> usize {
        let other = graph.edges[edge].other(element);
        self.points.of(if graph.role(other).is_point() { other } else { self.vertices + edge })
    }

    /// The points at the ends of an element, in source order.
    pub(crate) fn ends(&self, graph: &Graph<'_>, element: usize) -> Vec<usize> {
        graph.edges_of(element).map(|(edge, _)| self.end(graph, edge, element)).collect()
    }

    /// The points at the input and at the output of an element, which has both.
    pub(crate) fn input_output(&self, graph: &Graph<'_>, element: usize) -> [usize; 2] {
        let at = |is_end: fn(&super::graph::Edge<'_>, usize) -> bool| {
            let found = graph.edges_of(element).find(|(_, edge)| is_end(edge, element));
            // `check` refuses elements without input or output
            found.map_or(element, |(edge, _)| self.end(graph, edge, element))
        };
        [at(|edge, element| edge.to == element), at(|edge, element| edge.from == element)]
    }

    /// The point to which a vertex belongs, or that an arrow between two elements is.
    pub(crate) fn point(&self, of: usize) -> usize {
        self.points.of(of)
    }

    /// The place of a point.
    pub(crate) fn place(&self, of: usize) -> usize {
        self.places.of(of)
    }

    pub(crate) fn is_located(&self, point: usize) -> bool {
        self.located.contains(&self.place(point))
    }

    /// Whether it is unknown what stands at the place of a point.
    pub(crate) fn is_doubtful(&self, point: usize) -> bool {
        self.doubtful.contains(&self.place(point))
    }

    /// Whether an element needs a place for the point, and no `at` says it.
    pub(crate) fn lacks_place(&self, point: usize) -> bool {
        self.needed.contains(&self.place(point)) && !self.is_located(point)
    }

    /// All points, named ones first: those that are vertices, and those between two elements.
    pub(crate) fn all(&self, graph: &Graph<'_>) -> Vec<usize> {
        let of_vertices = (0..self.vertices).filter(|&vertex| graph.role(vertex).is_point());
        let is_between = |edge: &usize| graph.edges[*edge].ends().iter().all(|&end| !graph.role(end).is_point());
        let of_edges = (0..graph.edges.len()).filter(is_between).map(|edge| self.vertices + edge);
        of_vertices.chain(of_edges).filter(|&point| self.points.of(point) == point).collect()
    }

    /// The vertices of a point.
    pub(crate) fn vertices_at<'g>(&'g self, graph: &'g Graph<'_>, point: usize) -> impl Iterator<Item = usize> + 'g {
        (0..self.vertices).filter(move |&vertex| graph.role(vertex).is_point() && self.points.of(vertex) == point)
    }

    /// A number for each arrow that no point has, for the motion of a path at a point.
    pub(crate) fn of_edge(&self, edge: usize) -> usize {
        self.vertices + edge
    }
}

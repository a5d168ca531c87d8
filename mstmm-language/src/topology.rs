//! The graph of a model: vertices and directed edges, labels resolved.

use crate::ast::{Connection, Element, Label, Model, Node, Support};
use crate::diagnostics::{Errors, Place};
use std::collections::{BTreeMap, BTreeSet};
use syn::Ident;

/// A vertex. Each mention of a support is a separate vertex; all mentions of a connection are one.
pub(crate) enum Vertex<'a> {
    Support(&'a Ident),
    Connection(&'a Connection),
    Element(&'a Element),
}

impl Vertex<'_> {
    /// The tokens to point at.
    pub(crate) fn place(&self) -> Place {
        match self {
            Vertex::Support(keyword) => keyword.span().into(),
            Vertex::Connection(connection) => connection.place(),
            Vertex::Element(element) => element.place(),
        }
    }

    /// Whether this is an element without parameters.
    fn is_mention(&self) -> bool {
        matches!(self, Vertex::Element(element) if element.parameters.is_none())
    }

    /// How the user calls it.
    pub(crate) fn name(&self) -> String {
        match self {
            Vertex::Support(keyword) => keyword.to_string(),
            Vertex::Connection(connection) => connection.to_string(),
            Vertex::Element(element) => element.to_string(),
        }
    }
}

/// An arrow from an output to an input.
pub(crate) struct Edge {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) place: Place,
}

/// The vertices that have a label, by whether they are connections: these and elements have sets of their own.
pub(crate) type Labels = BTreeMap<(bool, String), usize>;

/// Vertices and edges in source order.
pub(crate) struct Graph<'a> {
    pub(crate) vertices: Vec<Vertex<'a>>,
    pub(crate) edges: Vec<Edge>,
    /// Vertices that share a label with another: it is unknown which of them an arrow meant.
    pub(crate) ambiguous: BTreeSet<usize>,
}

impl<'a> Graph<'a> {
    /// The graph of a model. A label that two elements share is an error.
    pub(crate) fn of(model: &'a Model, errors: &mut Errors) -> Self {
        let mut graph = Graph { vertices: Vec::new(), edges: Vec::new(), ambiguous: BTreeSet::new() };
        let mut labels = Labels::new();
        for path in &model.paths {
            let mut previous = graph.vertex(&path.first, &mut labels, errors);
            for (arrow, node) in &path.rest {
                let next = graph.vertex(node, &mut labels, errors);
                let (from, to) = if arrow.forward { (previous, next) } else { (next, previous) };
                graph.edges.push(Edge { from, to, place: arrow.place });
                previous = next;
            }
        }
        graph
    }

    /// The vertex of a node: a new one, unless it is a connection that was mentioned before.
    fn vertex(&mut self, node: &'a Node, labels: &mut Labels, errors: &mut Errors) -> usize {
        let new = self.vertices.len();
        let (label, vertex) = match node {
            Node::Support(Support { keyword, .. }) => {
                self.vertices.push(Vertex::Support(keyword));
                return new;
            }
            Node::Connection(connection) => (&connection.label, Vertex::Connection(connection)),
            Node::Element(element) => (&element.label, Vertex::Element(element)),
        };
        let is_connection = matches!(vertex, Vertex::Connection(_));
        let Some(&known) = labels.get(&(is_connection, label.to_string())) else {
            labels.insert((is_connection, label.to_string()), new);
            self.vertices.push(vertex);
            return new;
        };
        if is_connection {
            return known;
        }
        let first = &self.vertices[known];
        // an element named again without its parameters has a message of its own
        if !(first.is_mention() || vertex.is_mention()) {
            refuse_label(label, &first.name(), errors);
        }
        self.vertices.push(vertex);
        self.ambiguous.extend([known, new]);
        new
    }

    /// Vertices with an arrow into `vertex`, in source order.
    pub(crate) fn inputs(&self, vertex: usize) -> Vec<usize> {
        self.edges.iter().filter(|edge| edge.to == vertex).map(|edge| edge.from).collect()
    }

    /// The first vertex to which an arrow leads from `vertex`.
    pub(crate) fn output(&self, vertex: usize) -> Option<usize> {
        self.edges.iter().find(|edge| edge.from == vertex).map(|edge| edge.to)
    }

    /// Whether the ends of an arrow are joined by other arrows too, in whatever directions these point.
    pub(crate) fn is_in_a_loop(&self, edge: usize) -> bool {
        let mut reached = vec![false; self.vertices.len()];
        let mut pending = vec![self.edges[edge].from];
        while let Some(vertex) = pending.pop() {
            if std::mem::replace(&mut reached[vertex], true) {
                continue;
            }
            let others = self.edges.iter().enumerate().filter(|(index, _)| *index != edge);
            for (_, other) in others {
                if other.from == vertex {
                    pending.push(other.to);
                } else if other.to == vertex {
                    pending.push(other.from);
                }
            }
        }
        reached[self.edges[edge].to]
    }
}

/// Reports a label that another element has.
pub(crate) fn refuse_label(label: &Label, taken_by: &str, errors: &mut Errors) {
    let message = format!(
        "label `{label}` is taken by `{taken_by}`: elements share one set of labels, and an element is written once"
    );
    errors.push(label.span(), message);
}

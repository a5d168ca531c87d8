//! The graph of a model with locations: nodes and the arrows between them, labels resolved.

use crate::ast::{Arrow, Connection, Coordinates, Element, Kind, Label, Model, Node, Support};
use crate::diagnostics::{Errors, Place};
use crate::keywords::{LocatedKeyword, Role, support_of};
use crate::topology::{Labels, refuse_label};

/// A vertex. All mentions of a connection are one, and all of a rigid body; each mention of a support is another.
pub(crate) struct Vertex<'a> {
    pub(crate) node: Named<'a>,
    pub(crate) role: Role,
}

/// The first mention of a vertex; of a rigid body that with its parameters.
#[derive(Clone, Copy)]
pub(crate) enum Named<'a> {
    Support(&'a Support),
    Connection(&'a Connection),
    Element(&'a Element),
}

impl<'a> Vertex<'a> {
    fn support(support: &'a Support) -> Self {
        let is_known = support.held.is_some() || support_of(&support.keyword.to_string()).is_some();
        let role = if is_known || support.location.is_some() { Role::Support } else { Role::Unknown };
        Vertex { node: Named::Support(support), role }
    }

    fn connection(connection: &'a Connection) -> Self {
        let role = if connection.label.is_well_formed() { Role::Connection } else { Role::Unknown };
        Vertex { node: Named::Connection(connection), role }
    }

    fn element(element: &'a Element) -> Self {
        let role = match element.kind {
            _ if !element.label.is_well_formed() => Role::Unknown,
            Kind::Type(_) => Role::Path,
            Kind::Keyword(_) => element.located().map_or(Role::Unknown, |row| row.role),
        };
        Vertex { node: Named::Element(element), role }
    }

    /// The tokens to point at.
    pub(crate) fn place(&self) -> Place {
        match self.node {
            Named::Support(support) => support.keyword.span().into(),
            Named::Connection(connection) => connection.place(),
            Named::Element(element) => element.place(),
        }
    }

    /// How the user calls it.
    pub(crate) fn name(&self) -> String {
        match self.node {
            Named::Support(support) => support.keyword.to_string(),
            Named::Connection(connection) => connection.to_string(),
            Named::Element(element) => element.to_string(),
        }
    }

    pub(crate) fn as_element(&self) -> Option<&'a Element> {
        if let Named::Element(element) = self.node { Some(element) } else { None }
    }

    /// The row of its keyword, if it is an element.
    pub(crate) fn row(&self) -> Option<&'static LocatedKeyword> {
        self.as_element()?.located()
    }

    /// Whether it is an element without parameters.
    fn is_mention(&self) -> bool {
        self.as_element().is_some_and(|element| element.parameters.is_none())
    }
}

/// An arrow from an output to an input.
pub(crate) struct Edge<'a> {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) arrow: &'a Arrow,
}

impl<'a> Edge<'a> {
    /// The direction in which a path acts at this arrow.
    pub(crate) fn along(&self) -> Option<&'a Coordinates> {
        self.arrow.along.as_ref()
    }

    pub(crate) fn ends(&self) -> [usize; 2] {
        [self.from, self.to]
    }

    /// The end that is not `vertex`.
    pub(crate) fn other(&self, vertex: usize) -> usize {
        if self.from == vertex { self.to } else { self.from }
    }
}

/// An `at` of a vertex.
pub(crate) struct Location<'a> {
    pub(crate) vertex: usize,
    pub(crate) at: &'a Coordinates,
}

/// Vertices, edges and locations in source order.
#[derive(Default)]
pub(crate) struct Graph<'a> {
    pub(crate) vertices: Vec<Vertex<'a>>,
    pub(crate) edges: Vec<Edge<'a>>,
    pub(crate) locations: Vec<Location<'a>>,
}

impl<'a> Graph<'a> {
    /// The graph of a model. Reports labels that two elements share.
    pub(crate) fn of(model: &'a Model, errors: &mut Errors) -> Self {
        let mut graph = Graph::default();
        let mut labels = Labels::new();
        for path in &model.paths {
            let mut previous = graph.vertex(&path.first, &mut labels, errors);
            for (arrow, node) in &path.rest {
                let next = graph.vertex(node, &mut labels, errors);
                let (from, to) = if arrow.forward { (previous, next) } else { (next, previous) };
                graph.edges.push(Edge { from, to, arrow });
                previous = next;
            }
        }
        graph
    }

    /// The vertex of a node: a new one, unless it is a connection or a rigid body that was mentioned before.
    fn vertex(&mut self, node: &'a Node, labels: &mut Labels, errors: &mut Errors) -> usize {
        let (label, vertex) = match node {
            Node::Support(support) => (None, Vertex::support(support)),
            Node::Connection(connection) => (Some(&connection.label), Vertex::connection(connection)),
            Node::Element(element) => (Some(&element.label), Vertex::element(element)),
        };
        let index = match label {
            Some(label) => self.labelled(label, vertex, labels, errors),
            None => self.push(vertex),
        };
        if let (Some(at), Node::Support(_) | Node::Connection(_)) = (node.location(), node) {
            self.locations.push(Location { vertex: index, at });
        }
        index
    }

    fn push(&mut self, vertex: Vertex<'a>) -> usize {
        self.vertices.push(vertex);
        self.vertices.len() - 1
    }

    fn labelled(&mut self, label: &Label, mut vertex: Vertex<'a>, labels: &mut Labels, errors: &mut Errors) -> usize {
        let is_connection = matches!(vertex.node, Named::Connection(_));
        let Some(&known) = labels.get(&(is_connection, label.to_string())) else {
            let new = self.push(vertex);
            labels.insert((is_connection, label.to_string()), new);
            return new;
        };
        let first = &mut self.vertices[known];
        if is_connection || (first.role, vertex.role) == (Role::RigidBody, Role::RigidBody) {
            if first.is_mention() && !vertex.is_mention() {
                *first = vertex;
            }
            return known;
        }
        // an element named again without its parameters has a message of its own
        if !(first.is_mention() || vertex.is_mention()) {
            refuse_label(label, &first.name(), errors);
        }
        first.role = Role::Unknown;
        vertex.role = Role::Unknown;
        self.push(vertex)
    }

    /// The edges of a vertex, with their indices.
    pub(crate) fn edges_of(&self, vertex: usize) -> impl Iterator<Item = (usize, &Edge<'a>)> {
        self.edges.iter().enumerate().filter(move |(_, edge)| edge.ends().contains(&vertex))
    }

    pub(crate) fn role(&self, vertex: usize) -> Role {
        self.vertices[vertex].role
    }

    /// All vertices of a role.
    pub(crate) fn with_role(&self, role: Role) -> impl Iterator<Item = usize> {
        (0..self.vertices.len()).filter(move |&vertex| self.role(vertex) == role)
    }

    /// The element at a vertex, which has the role of one.
    pub(crate) fn elements(&self, role: Role) -> impl Iterator<Item = (usize, &'a Element)> {
        self.with_role(role).filter_map(|vertex| Some((vertex, self.vertices[vertex].as_element()?)))
    }
}

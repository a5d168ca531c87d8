//! Assembles the network from a graph without errors.

use super::freedoms::{FreedomSet, freedoms};
use super::graph::{Graph, Named};
use super::hand_over::{
    Direction, Holds, Joint, Member, Network, PathContact, PathElement, PathNode, Point, PointMass, RigidBody, Support,
    Suspicion, TransferPath,
};
use super::paths::{Contact, Path, PathMotion, Paths};
use super::points::Points;
use crate::ast::{self, Connection, Element};
use crate::keywords::{Dimension, Role, freedom_of, support_of};
use mstmm_plan::Freedoms;
use mstmm_plan::Support::{Fixed, Guided, Pinned, Roller};
use syn::ext::IdentExt;

impl<'a> Network<'a> {
    /// The network of a graph that `check` has found right.
    pub(crate) fn of(
        graph: &Graph<'a>,
        points: &Points,
        paths: &Paths<'a>,
        dimension: Dimension,
        suspicions: Vec<Suspicion<'a>>,
    ) -> Self {
        let located: Vec<usize> = points.all(graph).into_iter().filter(|&point| points.is_located(point)).collect();
        let freedoms = freedoms(graph, points, paths, dimension);
        let assembly = Assembly { graph, points, paths, dimension, located, freedoms };
        Network {
            dimension,
            places: graph.locations.iter().map(|location| location.at).collect(),
            supports: assembly.supports(),
            points: assembly.points(),
            members: assembly.between(Role::Member).map(|(element, ends)| Member { element, ends }).collect(),
            joints: assembly
                .between(Role::Joint)
                .map(|(element, ends)| {
                    let axis = ["along", "axis"].map(|name| element.tuple(name)).concat();
                    Joint { element, ends, axis }
                })
                .collect(),
            bodies: assembly.bodies(),
            masses: assembly.masses(),
            paths: paths.all.iter().map(|path| assembly.path(path)).collect(),
            suspicions,
        }
    }
}

/// What the parts of a network are made from.
struct Assembly<'g, 'a> {
    graph: &'g Graph<'a>,
    points: &'g Points,
    paths: &'g Paths<'a>,
    dimension: Dimension,
    /// The representatives of points with places, in the order of the network.
    located: Vec<usize>,
    /// The freedoms of each point, by its representative.
    freedoms: Vec<FreedomSet<'a>>,
}

impl<'a> Assembly<'_, 'a> {
    /// The index of a point with a place.
    fn index(&self, point: usize) -> usize {
        position(&self.located, &point)
    }

    fn points(&self) -> Vec<Point<'a>> {
        let places: Vec<usize> =
            self.graph.locations.iter().map(|location| self.points.place(location.vertex)).collect();
        let point = |&point: &usize| Point {
            place: position(&places, &self.points.place(point)),
            connections: self.connections(self.points.vertices_at(self.graph, point)),
            freedoms: self.freedoms[point].clone(),
        };
        self.located.iter().map(point).collect()
    }

    fn connections(&self, vertices: impl Iterator<Item = usize>) -> Vec<&'a Connection> {
        let connection = |vertex: usize| match self.graph.vertices[vertex].node {
            Named::Connection(connection) => Some(connection),
            Named::Support(_) | Named::Element(_) => None,
        };
        vertices.filter_map(connection).collect()
    }

    fn supports(&self) -> Vec<Support<'a>> {
        let support = |vertex: usize| {
            let point = self.points.point(vertex);
            match self.graph.vertices[vertex].node {
                Named::Support(support) if self.points.is_located(point) => Some(Support {
                    support,
                    point: self.index(point),
                    holds: holds(support, self.dimension, self.freedoms[point].possible()),
                }),
                _ => None,
            }
        };
        self.graph.with_role(Role::Support).filter_map(support).collect()
    }

    /// The elements of a role, each with the points at its input and at its output.
    fn between(&self, role: Role) -> impl Iterator<Item = (&'a Element, [usize; 2])> {
        self.graph.elements(role).map(|(vertex, element)| {
            (element, self.points.input_output(self.graph, vertex).map(|point| self.index(point)))
        })
    }

    fn bodies(&self) -> Vec<RigidBody<'a>> {
        let body = |(vertex, element): (usize, &'a Element)| {
            let mut points: Vec<usize> = Vec::new();
            for point in self.points.ends(self.graph, vertex).into_iter().map(|point| self.index(point)) {
                if !points.contains(&point) {
                    points.push(point);
                }
            }
            RigidBody { element, centre: element.tuple("centre"), points }
        };
        self.graph.elements(Role::RigidBody).map(body).collect()
    }

    fn masses(&self) -> Vec<PointMass<'a>> {
        let masses = self.graph.elements(Role::PointMass);
        masses.map(|(vertex, element)| PointMass { element, point: self.index(self.points.point(vertex)) }).collect()
    }

    fn path(&self, path: &Path<'a>) -> TransferPath<'a> {
        let graph = self.graph;
        let mut nodes: Vec<usize> = path.contacts.iter().map(|contact| contact.node).collect();
        let ends_of = |&element: &usize| {
            let node = |edge| self.paths.node(graph, self.points, edge, element);
            graph.edges_of(element).map(|(edge, arrow)| (arrow.from == element, node(edge))).collect::<Vec<_>>()
        };
        nodes.extend(path.elements.iter().flat_map(ends_of).map(|(_, node)| node));
        nodes.sort_unstable();
        nodes.dedup();
        let elements = path.elements.iter().filter_map(|vertex| {
            let mut ends = ends_of(vertex);
            // the input first
            ends.sort_unstable();
            let ends = [ends.first()?.1, ends.last()?.1].map(|node| position(&nodes, &node));
            Some(PathElement { element: graph.vertices[*vertex].as_element()?, ends })
        });
        TransferPath {
            motion: path.motion,
            elements: elements.collect(),
            contacts: path.contacts.iter().map(|contact| self.contact(path, contact, &nodes)).collect(),
            nodes: nodes.iter().map(|&node| self.node(node)).collect(),
        }
    }

    fn node(&self, node: usize) -> PathNode<'a> {
        let is_of_node = |&vertex: &usize| {
            let role = self.graph.role(vertex);
            role.is_point()
                && !self.points.is_located(vertex)
                && self.paths.node_of_point(self.points.point(vertex)) == node
        };
        let vertices: Vec<usize> = (0..self.graph.vertices.len()).filter(is_of_node).collect();
        let is_held = |&vertex: &usize| match self.graph.vertices[vertex].node {
            Named::Support(support) => support_of(&support.keyword.to_string()) == Some(Fixed),
            Named::Connection(_) | Named::Element(_) => false,
        };
        PathNode { is_held: vertices.iter().any(is_held), connections: self.connections(vertices.into_iter()) }
    }

    fn contact(&self, path: &Path<'_>, contact: &Contact, nodes: &[usize]) -> PathContact<'a> {
        let direction = match self.graph.edges[contact.edge].along() {
            _ if matches!(path.motion, PathMotion::Rotation) && self.dimension != Dimension::Space => Direction::Z,
            _ if self.dimension == Dimension::Line => Direction::Y,
            Some(along) => Direction::Along(along),
            // a path that moves has two contacts, at two places
            None => match path.contacts.as_slice() {
                [from, to] if self.points.place(from.point) != self.points.place(to.point) => {
                    Direction::FromTo([from, to].map(|contact| self.index(contact.point)))
                }
                _ => Direction::Z,
            },
        };
        PathContact { node: position(nodes, &contact.node), point: self.index(contact.point), direction }
    }
}

/// What a support holds of the freedoms that its point has, or may have.
fn holds(support: &ast::Support, dimension: Dimension, freedoms: Freedoms) -> Holds<'_> {
    if let Some(held) = &support.held {
        let held = held.iter().filter_map(|name| freedom_of(&name.unraw().to_string()));
        return Holds::Freedoms(held.fold(Freedoms::NONE, Freedoms::union).intersection(freedoms));
    }
    let keyword = support_of(&support.keyword.to_string());
    match (keyword, &support.direction) {
        (Some(Roller), Some(direction)) => Holds::Skew(direction, Freedoms::NONE),
        (Some(Guided), Some(direction)) => Holds::Skew(direction, Freedoms::ROTATIONS.intersection(freedoms)),
        (keyword, _) => {
            let held = match keyword {
                Some(Fixed) => Freedoms::SPACE,
                Some(Pinned) if dimension == Dimension::Space => Freedoms::DISPLACEMENTS,
                keyword => keyword.map_or(Freedoms::NONE, mstmm_plan::Support::holds),
            };
            Holds::Freedoms(held.intersection(freedoms))
        }
    }
}

/// The index of a thing in a list, which has it.
fn position<T: PartialEq>(list: &[T], thing: &T) -> usize {
    list.iter().position(|other| other == thing).unwrap_or(0)
}

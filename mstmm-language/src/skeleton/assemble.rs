//! The skeleton of a checked network.

use super::names::{Naming, join_name};
use super::{Axis, Body, End, Member, Node, Point, Skeleton, Vector, What};
use crate::ast::{Coordinates, Element};
use crate::keywords::located_of;
use crate::network::{Classes, Holds, Joint, Network, Support};
use mstmm_plan::Freedoms;
use std::collections::BTreeSet;
use syn::Expr;

impl<'a> Skeleton<'a> {
    /// The nodes and members of a network.
    pub(crate) fn of(network: &'a Network<'a>) -> Self {
        let mut assembly = Assembly::new(network);
        network.supports.iter().for_each(|support| assembly.support(support));
        for body in &network.bodies {
            assembly.body(body.element, body.points[0], &body.centre);
        }
        for mass in &network.masses {
            let place = network.points[mass.point].place;
            assembly.body(mass.element, mass.point, &network.places[place].parts);
        }
        for member in &network.members {
            let ends = member.ends.map(|point| assembly.end(point, Axis::Member));
            let freedoms = network.dimension.freedoms();
            assembly.element(member.element, freedoms, ends);
        }
        network.joints.iter().for_each(|joint| assembly.joint(joint));
        network.paths.iter().for_each(|path| assembly.path(path));
        assembly.points();
        assembly.skeleton
    }
}

/// A skeleton at work.
pub(super) struct Assembly<'a> {
    pub(super) network: &'a Network<'a>,
    pub(super) skeleton: Skeleton<'a>,
    naming: Naming<'a>,
    /// The node of each point.
    node_of: Vec<usize>,
    /// Whether a support holds each node.
    is_supported: Vec<bool>,
}

impl<'a> Assembly<'a> {
    /// The nodes of all points, and no members yet.
    fn new(network: &'a Network<'a>) -> Self {
        let naming = Naming::of(network);
        let mut classes = Classes::new(network.points.len());
        for body in &network.bodies {
            body.points.iter().for_each(|&point| classes.join(body.points[0], point));
        }
        let place =
            |(index, place): (usize, &&'a Coordinates)| Vector { name: naming.place(index), parts: &place.parts };
        let mut skeleton =
            Skeleton { places: network.places.iter().enumerate().map(place).collect(), ..Skeleton::default() };
        let mut node_of = Vec::new();
        for (index, point) in network.points.iter().enumerate() {
            let first = classes.of(index);
            if first < index {
                node_of.push(node_of[first]);
                continue;
            }
            node_of.push(skeleton.nodes.len());
            let (name, freedoms) = (naming.node(index), point.freedoms);
            let held = Freedoms::ALL.without(freedoms);
            skeleton.nodes.push(Node { name, place: Some(point.place), freedoms, held, along: None });
        }
        let is_supported = vec![false; skeleton.nodes.len()];
        Assembly { network, skeleton, naming, node_of, is_supported }
    }

    /// The connections with a place, each once.
    fn points(&mut self) {
        let mut named = BTreeSet::new();
        for (point, node) in self.network.points.iter().zip(&self.node_of) {
            for connection in point.connections.iter().filter(|connection| named.insert(connection.label.to_string())) {
                let (place, freedoms) = (point.place, point.freedoms);
                self.skeleton.points.push(Point { connection, node: *node, place, freedoms });
            }
        }
    }

    /// A support holds the node of its point. A second one on a body holds another place of it, by a rigid joint with the ground.
    fn support(&mut self, support: &'a Support<'a>) {
        if matches!(support.holds, Holds::Freedoms(held) if held.is_empty()) {
            return;
        }
        let node = self.node_of[support.point];
        let (place, all) = (self.network.points[support.point].place, self.network.points[support.point].freedoms);
        let name = join_name(&support.support.keyword.to_string(), &self.naming.point(support.point));
        let (held, direction) = match support.holds {
            Holds::Freedoms(freedoms) => (freedoms, None),
            Holds::Across(direction, freedoms) => (freedoms, Some(self.direction(name.clone(), &direction.parts))),
        };
        if !self.is_supported[node] {
            self.is_supported[node] = true;
            let node = &mut self.skeleton.nodes[node];
            let lacks = node.held;
            (node.place, node.along, node.held) = (Some(place), direction, held.union(lacks));
            if direction.is_some() {
                node.held = node.held.intersection(Freedoms::RZ);
            }
            return;
        }
        let ground = self.skeleton.nodes.len();
        self.skeleton.nodes.push(Node {
            name: name.clone(),
            place: Some(place),
            freedoms: all,
            held: Freedoms::ALL,
            along: None,
        });
        let axis = direction.map_or(Axis::X, Axis::Along);
        let freedoms = if direction.is_some() { held.union(Freedoms::Y) } else { held };
        let ends = [ground, node].map(|node| End { node, place: Some(place), axis });
        self.skeleton.members.push(Member { what: What::Rigid, name, freedoms, ends });
    }

    fn body(&mut self, element: &'a Element, point: usize, centre: &'a [Expr]) {
        self.skeleton.bodies.push(Body { element, node: self.node_of[point], centre });
    }

    fn joint(&mut self, joint: &'a Joint<'a>) {
        let name = joint.element.to_string();
        let axis = match joint.along.as_slice() {
            [] => Axis::X,
            along => Axis::Along(self.direction(name.clone(), along)),
        };
        let ends = joint.ends.map(|point| self.end(point, axis));
        let keyword = joint.element.kind.name().to_string();
        // a slider moves along its x
        let ties = match keyword.as_str() {
            "slider" => Freedoms::Y.union(Freedoms::RZ),
            _ => located_of(&keyword).map_or(Freedoms::NONE, |row| row.brings),
        };
        let freedoms = ties.intersection(self.network.dimension.freedoms());
        // a hinge has its stiffnesses, other joints are rigid
        let what = if joint.element.kind.known().is_some() { What::Hinge(joint.element) } else { What::Rigid };
        self.skeleton.members.push(Member { what, name, freedoms, ends });
    }

    pub(super) fn element(&mut self, element: &'a Element, freedoms: Freedoms, ends: [End; 2]) {
        self.skeleton.members.push(Member { what: What::Element(element), name: element.to_string(), freedoms, ends });
    }

    /// The end of a member at a point.
    pub(super) fn end(&self, point: usize, axis: Axis) -> End {
        End { node: self.node_of[point], place: Some(self.network.points[point].place), axis }
    }

    /// A direction, by its index.
    pub(super) fn direction(&mut self, name: String, parts: &'a [Expr]) -> usize {
        self.skeleton.directions.push(Vector { name, parts });
        self.skeleton.directions.len() - 1
    }
}

//! The skeleton of a checked network.

use super::names::{Naming, join_name};
use super::{Axis, Body, End, Member, Node, Point, Seat, Skeleton, Support, Vector, What};
use crate::ast::{Coordinates, Element};
use crate::keywords::{LocatedKeyword, located_of};
use crate::network::{self, Classes, FreedomSet, Holds, Joint, Network};
use mstmm_plan::Freedoms;
use syn::Expr;

impl<'a> Skeleton<'a> {
    /// The nodes and members of a network.
    pub(crate) fn of(network: &'a Network<'a>) -> Self {
        let mut assembly = Assembly::new(network);
        network.supports.iter().for_each(|support| assembly.support(support));
        for body in &network.bodies {
            // a link has no mass, and stands where it begins
            let place = network.points[body.points[0]].place;
            let centre = if body.centre.is_empty() { &network.places[place].parts } else { &body.centre };
            assembly.body(body.element, body.points[0], centre);
        }
        for mass in &network.masses {
            let place = network.points[mass.point].place;
            assembly.body(mass.element, mass.point, &network.places[place].parts);
        }
        for member in &network.members {
            let ends = member.ends.map(|point| End { seat: Seat::Point(point), axis: Axis::Member });
            let acts_in = member.element.located().map_or(Freedoms::PLANE, LocatedKeyword::acts_in);
            let freedoms = FreedomSet::known(acts_in.intersection(network.dimension.freedoms()));
            assembly.element(member.element, freedoms, ends);
        }
        network.joints.iter().for_each(|joint| assembly.joint(joint));
        network.paths.iter().for_each(|path| assembly.path(path));
        assembly.skeleton
    }
}

/// A skeleton at work.
pub(super) struct Assembly<'a> {
    pub(super) network: &'a Network<'a>,
    pub(super) skeleton: Skeleton<'a>,
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
        for (index, point) in network.points.iter().enumerate() {
            let (place, freedoms) = (point.place, &point.freedoms);
            let first = classes.of(index);
            let node = if first < index { skeleton.points[first].node } else { skeleton.nodes.len() };
            let (name, connections) = (naming.point(index), &point.connections);
            skeleton.points.push(Point { name, connections, node, place, freedoms: freedoms.clone() });
            if first == index {
                let (name, freedoms) = (naming.node(index), freedoms.clone());
                skeleton.nodes.push(Node { name, place: Some(place), freedoms, held: Freedoms::NONE, along: None });
            }
        }
        let is_supported = vec![false; skeleton.nodes.len()];
        Assembly { network, skeleton, is_supported }
    }

    /// A support holds the node of its point. A second one on a body holds another place of it, by a rigid joint with the ground.
    fn support(&mut self, support: &'a network::Support<'a>) {
        if matches!(support.holds, Holds::Freedoms(held) if held.is_empty()) {
            return;
        }
        let Point { node, place, ref freedoms, .. } = self.skeleton.points[support.point];
        let all = freedoms.clone();
        let name = join_name(&support.support.keyword.to_string(), &self.skeleton.points[support.point].name);
        let (held, direction) = match support.holds {
            Holds::Freedoms(freedoms) => (freedoms, None),
            Holds::Across(direction, freedoms) => (freedoms, Some(self.direction(name.clone(), &direction.parts))),
        };
        let is_second = self.is_supported[node];
        let holds = if is_second { self.skeleton.nodes.len() } else { node };
        let point = support.point;
        self.skeleton.supports.push(Support { name: name.clone(), point, node: holds, held, along: direction });
        if !is_second {
            self.is_supported[node] = true;
            let node = &mut self.skeleton.nodes[node];
            (node.place, node.along, node.held) = (Some(place), direction, held);
            return;
        }
        self.skeleton.nodes.push(Node {
            name: name.clone(),
            place: Some(place),
            freedoms: all,
            held: Freedoms::PLANE,
            along: None,
        });
        let axis = direction.map_or(Axis::X, Axis::Along);
        let freedoms = FreedomSet::known(if direction.is_some() { held.union(Freedoms::Y) } else { held });
        let ends = [Seat::Node(holds), Seat::Point(point)].map(|seat| End { seat, axis });
        self.skeleton.members.push(Member { what: What::Rigid, name, kind: None, freedoms, ends });
    }

    fn body(&mut self, element: &'a Element, point: usize, centre: &'a [Expr]) {
        self.skeleton.bodies.push(Body { element, node: self.skeleton.points[point].node, centre });
    }

    fn joint(&mut self, joint: &'a Joint<'a>) {
        let name = joint.element.to_string();
        let axis = match joint.along.as_slice() {
            [] => Axis::X,
            along => Axis::Along(self.direction(name.clone(), along)),
        };
        let ends = joint.ends.map(|point| End { seat: Seat::Point(point), axis });
        let keyword = joint.element.kind.name().to_string();
        // a slider moves along its x
        let ties = match keyword.as_str() {
            "slider" => Freedoms::Y.union(Freedoms::RZ),
            _ => located_of(&keyword).map_or(Freedoms::NONE, |row| row.brings),
        };
        let freedoms = FreedomSet::known(ties.intersection(self.network.dimension.freedoms()));
        // a hinge has its stiffnesses, other joints are rigid
        let what = if joint.element.known().is_some() { What::Hinge(joint.element) } else { What::Rigid };
        self.skeleton.members.push(Member { what, name, kind: Some(joint.element.type_name()), freedoms, ends });
    }

    pub(super) fn element(&mut self, element: &'a Element, freedoms: FreedomSet<'a>, ends: [End; 2]) {
        let (name, kind) = (element.to_string(), Some(element.type_name()));
        self.skeleton.members.push(Member { what: What::Element(element), name, kind, freedoms, ends });
    }

    /// A direction, by its index.
    pub(super) fn direction(&mut self, name: String, parts: &'a [Expr]) -> usize {
        self.skeleton.directions.push(Vector { name, parts });
        self.skeleton.directions.len() - 1
    }
}

//! The skeleton of a checked network.

use super::names::{Naming, join_name};
use super::{Axis, Body, Direction, End, Member, Node, Place, Plane, Point, Seat, Skeleton, Skew, Support, Up, What};
use crate::ast::Element;
use crate::keywords::{ALONG, Dimension, LocatedKeyword, NORMAL, ties};
use crate::network::{self, Classes, FreedomSet, Holds, Joint, Network};
use mstmm_plan::{Freedoms, MOST_PARTS, freedoms_in_part};
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
        network.members.iter().for_each(|member| assembly.member(member));
        network.joints.iter().for_each(|joint| assembly.joint(joint));
        network.paths.iter().for_each(|path| assembly.path(path));
        assembly.skeleton
    }
}

/// The plane of a part.
fn plane_of(part: usize, up: Up) -> Plane {
    match part {
        0 => Plane::First(up),
        1 => Plane::Second(up),
        _ => Plane::Twist,
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
        let places = network.places.iter().enumerate();
        let places = places.map(|(index, place)| Place { name: naming.place(index), parts: place.parts.clone() });
        let mut skeleton = Skeleton {
            dimension: network.dimension,
            places: places.collect(),
            directions: Vec::new(),
            bodies: Vec::new(),
            nodes: Vec::new(),
            members: Vec::new(),
            points: Vec::new(),
            supports: Vec::new(),
        };
        let all = all_of(network.dimension);
        for (index, point) in network.points.iter().enumerate() {
            let (place, freedoms) = (point.place, &point.freedoms);
            let first = classes.of(index);
            let node = if first < index { skeleton.points[first].node } else { skeleton.nodes.len() };
            let (name, connections) = (naming.point(index), &point.connections);
            skeleton.points.push(Point { name, connections, node, place, freedoms: freedoms.clone() });
            if first == index {
                let (name, freedoms) = (naming.node(index), freedoms.clone());
                let (place, held, skew) = (Some(place), Freedoms::NONE, None);
                skeleton.nodes.push(Node { name, place, freedoms, held, skew, all });
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
        let (held, skew) = match support.holds {
            Holds::Freedoms(freedoms) => (freedoms, None),
            Holds::Skew(direction, freedoms) => {
                let word = direction.keyword.to_string();
                let is_normal = word == NORMAL;
                let direction = self.direction(name.clone(), &word, &direction.parts);
                (freedoms, Some(Skew { direction, is_normal }))
            }
        };
        let is_second = self.is_supported[node];
        let holds = if is_second { self.skeleton.nodes.len() } else { node };
        let point = support.point;
        self.skeleton.supports.push(Support { name: name.clone(), point, node: holds, held, skew });
        if !is_second {
            self.is_supported[node] = true;
            let node = &mut self.skeleton.nodes[node];
            (node.place, node.skew, node.held) = (Some(place), skew, held);
            return;
        }
        self.skeleton.nodes.push(Node {
            name: name.clone(),
            place: Some(place),
            freedoms: all,
            held: self.all(),
            skew: None,
            all: self.all(),
        });
        let axis = skew.map_or(Axis::X, |skew| Axis::Along(skew.direction));
        let tied = match skew {
            None => held,
            Some(Skew { is_normal: true, .. }) => held.union(Freedoms::X),
            Some(_) => held.union(Freedoms::Y.union(Freedoms::Z).intersection(self.all())),
        };
        let ends = [Seat::Node(holds), Seat::Point(point)].map(|seat| End { seat, axis });
        self.tie(&name, None, tied, Up::Any, ends, |_| None);
    }

    /// The freedoms that nodes may have.
    pub(super) fn all(&self) -> Freedoms {
        all_of(self.network.dimension)
    }

    fn body(&mut self, element: &'a Element, point: usize, centre: &[Expr]) {
        let (node, centre) = (self.skeleton.points[point].node, centre.to_vec());
        self.skeleton.bodies.push(Body { element, node, centre });
    }

    /// An element with extent, by its parts.
    fn member(&mut self, member: &network::Member<'a>) {
        let ends = member.ends.map(|point| End { seat: Seat::Point(point), axis: Axis::Member });
        let (element, dimension) = (member.element, self.network.dimension);
        if dimension != Dimension::Space {
            let acts_in = element.located().map_or(Freedoms::PLANE, LocatedKeyword::acts_in);
            let freedoms = FreedomSet::known(acts_in.intersection(dimension.freedoms()));
            return self.element(element, freedoms, Plane::Structure, ends);
        }
        let up = self.up(element);
        for (part, own) in element.parts.iter().enumerate().filter_map(|(part, own)| Some((part, own.as_deref()?))) {
            self.element(own, FreedomSet::known(freedoms_of(own)), plane_of(part, up), ends);
            self.skeleton.members.last_mut().into_iter().for_each(|member| member.is_further = part > 0);
        }
    }

    /// The `up` of a member in space.
    fn up(&mut self, element: &'a Element) -> Up {
        match element.tuple("up").as_slice() {
            [] if element.is_symmetric() => Up::Any,
            [] => Up::Z,
            parts => Up::Named(self.direction(element.to_string(), "up", parts)),
        }
    }

    fn joint(&mut self, joint: &'a Joint<'a>) {
        let (name, element, is_in_space) =
            (joint.element.to_string(), joint.element, self.network.dimension == Dimension::Space);
        let axis = match joint.axis.as_slice() {
            [] => Axis::X,
            axis => {
                let word = if is_in_space { "axis" } else { ALONG };
                Axis::Along(self.direction(name.clone(), word, axis))
            }
        };
        let ends = joint.ends.map(|point| End { seat: Seat::Point(point), axis });
        let tied = ties(&element.kind.name().to_string()).intersection(self.network.dimension.freedoms());
        let kind = Some(element.type_name());
        // a hinge has its stiffnesses, other joints are rigid
        let is_hinge = element.known().is_some();
        if !is_in_space {
            let elastic = is_hinge.then_some(element);
            return self.tie(&name, kind, tied, Up::Any, ends, |_| elastic);
        }
        let up = if is_hinge { self.up(element) } else { Up::Any };
        self.tie(&name, kind, tied, up, ends, |part| element.parts[part].as_deref().filter(|own| gives_way(own)));
    }

    /// A joint between two ends by its parts, of which some are elastic.
    pub(super) fn tie(
        &mut self,
        name: &str,
        kind: Option<String>,
        tied: Freedoms,
        up: Up,
        ends: [End; 2],
        elastic: impl Fn(usize) -> Option<&'a Element>,
    ) {
        let is_in_space = self.network.dimension == Dimension::Space;
        let mut is_further = false;
        for part in 0..if is_in_space { MOST_PARTS } else { 1 } {
            let freedoms = freedoms_in_part(part, tied);
            if freedoms.is_empty() {
                continue;
            }
            let what = elastic(part).map_or(What::Rigid, What::Hinge);
            let plane = if is_in_space { plane_of(part, up) } else { Plane::Structure };
            let (name, kind, freedoms) = (name.to_owned(), kind.clone(), FreedomSet::known(freedoms));
            self.skeleton.members.push(Member { what, name, kind, freedoms, plane, is_further, ends });
            is_further = true;
        }
    }

    pub(super) fn element(&mut self, element: &'a Element, freedoms: FreedomSet<'a>, plane: Plane, ends: [End; 2]) {
        let (what, name, kind) = (What::Element(element), element.to_string(), Some(element.type_name()));
        self.skeleton.members.push(Member { what, name, kind, freedoms, plane, is_further: false, ends });
    }

    /// A direction, by its index.
    pub(super) fn direction(&mut self, name: String, word: &str, parts: &[Expr]) -> usize {
        self.skeleton.directions.push(Direction { name, word: word.to_owned(), parts: parts.to_vec() });
        self.skeleton.directions.len() - 1
    }
}

/// The freedoms that nodes of a dimension may have.
fn all_of(dimension: Dimension) -> Freedoms {
    if dimension == Dimension::Space { Freedoms::SPACE } else { Freedoms::PLANE }
}

/// The freedoms of a part of a member, in its own axes.
fn freedoms_of(part: &Element) -> Freedoms {
    let (along, across, turn) = (Freedoms::X, Freedoms::Y, Freedoms::RZ);
    let Some(row) = part.known() else { return Freedoms::NONE };
    let turns = row.required.contains(&"bending_stiffness");
    match (row.stretches(), row.space.is(mstmm_plan::Space::Rotation)) {
        (_, true) => turn,
        (true, _) if turns => along.union(across).union(turn),
        (true, _) => along.union(across),
        _ if turns => across.union(turn),
        _ => across,
    }
}

/// Whether a part of a hinge has a stiffness or a damping.
fn gives_way(part: &Element) -> bool {
    let is_flexible = |name: &syn::Ident| {
        let name = name.to_string();
        name.starts_with("stiffness_") || name.starts_with("damping_")
    };
    part.parameters().any(|parameter| is_flexible(&parameter.name))
}

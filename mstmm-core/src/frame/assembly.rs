//! The nodes and members of a frame: points that bodies tie are one node, supports hold it, paths have nodes of their own.

use crate::element::MemberElement;
use crate::elements::any_member::AnyMember;
use crate::elements::joint::Joint;
use crate::frame::dimension::Dimension;
use crate::frame::ends::{End, Seat};
use crate::frame::entries::{Frame, MemberEntry};
use crate::frame::error::{BuildError, Mistake};
use crate::frame::paths::motions;
use crate::model::{Hold, Tied};
use crate::pass::network::{self, Node};
use mstmm_plan::Freedoms;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

/// The displacements.
const XY: Freedoms = Freedoms::X.union(Freedoms::Y);

/// A member of the network that a frame is.
pub(crate) type NetworkMember = network::Member<AnyMember<f64>>;

/// The nodes and members of a frame.
pub(crate) struct Assembly<'f, D: Dimension> {
    frame: &'f Frame<D>,
    pub(crate) nodes: Vec<Node<f64>>,
    /// What each node is called: of points the first one, of paths the point of a path.
    pub(crate) names: Vec<String>,
    pub(crate) is_of_path: Vec<bool>,
    pub(crate) members: Vec<NetworkMember>,
    /// What each member is called.
    pub(crate) called: Vec<String>,
    /// The points of the frame, by their nodes.
    pub(crate) points: Vec<Tied>,
    /// The node and the mass centre of each body.
    pub(crate) bodies: Vec<(usize, [f64; 2])>,
    /// The freedoms that members and bodies bring to each point.
    brought: Vec<Freedoms>,
    paths: Vec<usize>,
    ground: Option<usize>,
    /// All that is wrong with its parts so far.
    pub(crate) errors: Vec<BuildError>,
}

/// What a part is called.
pub(crate) fn called(kind: &str, index: usize, name: Option<&String>) -> String {
    name.map_or_else(|| format!("{kind} {index}"), |name| format!("{kind} {name:?}"))
}

impl<'f, D: Dimension> Assembly<'f, D> {
    /// The nodes and members of a frame, without the parts that are wrong.
    pub(crate) fn of(frame: &'f Frame<D>) -> Self {
        let mut assembly = Assembly {
            frame,
            nodes: Vec::new(),
            names: Vec::new(),
            is_of_path: Vec::new(),
            members: Vec::new(),
            called: Vec::new(),
            points: Vec::new(),
            bodies: Vec::new(),
            brought: vec![Freedoms::NONE; frame.points.len()],
            paths: Vec::new(),
            ground: None,
            errors: Vec::new(),
        };
        for &call in &frame.strangers {
            assembly.errors.push(BuildError { part: format!("`{call}`"), mistake: Mistake::OtherFrame });
        }
        assembly.tie_points();
        assembly.add_paths();
        // members of the frame come first, so that their handles are their indices
        frame.members.iter().enumerate().for_each(|(index, member)| assembly.add_member(index, member));
        frame.masses.iter().for_each(|mass| assembly.add_mass(&mass.on, mass.mass));
        (0..frame.points.len()).for_each(|point| assembly.hold(point));
        assembly.settle();
        assembly
    }

    pub(crate) fn fail(&mut self, part: String, mistake: Mistake) {
        self.errors.push(BuildError { part, mistake });
    }

    fn point_name(&self, point: usize) -> String {
        called("point", point, self.frame.points[point].name.as_ref())
    }

    fn place(&self, point: usize) -> [f64; 2] {
        D::in_plane(self.frame.points[point].place)
    }

    fn add_node(&mut self, node: Node<f64>, name: String, is_of_path: bool) -> usize {
        self.nodes.push(node);
        self.names.push(name);
        self.is_of_path.push(is_of_path);
        self.nodes.len() - 1
    }

    /// A node for each set of points that bodies tie, at the first of them that is held.
    fn tie_points(&mut self) {
        let count = self.frame.points.len();
        let mut first: Vec<usize> = (0..count).collect();
        for (index, body) in self.frame.bodies.iter().enumerate() {
            let tied: Vec<_> = body.points.iter().map(|handle| self.frame.own(*handle, count)).collect();
            if tied.is_empty() || tied.contains(&None) {
                let mistake = if tied.is_empty() { Mistake::NoPoint } else { Mistake::OtherFrame };
                self.fail(called("body", index, body.name.as_ref()), mistake);
                continue;
            }
            let classes: Vec<usize> = tied.iter().flatten().map(|point| first[*point]).collect();
            let least = classes.iter().copied().min().unwrap_or(0);
            for class in &mut first {
                *class = if classes.contains(class) { least } else { *class };
            }
            let brought = if body.rigid.turns { Freedoms::ALL } else { XY };
            for point in tied.into_iter().flatten() {
                self.bring(point, brought);
            }
        }
        let is_held = |point: usize| !self.frame.points[point].holds.is_empty();
        let mut nodes = vec![None; count];
        for point in 0..count {
            let class = first[point];
            let node = nodes[class].unwrap_or_else(|| {
                let held = (point..count).find(|other| first[*other] == class && is_held(*other));
                let place = self.place(held.unwrap_or(point));
                self.add_node(Node::at(place), self.point_name(point), false)
            });
            nodes[class] = Some(node);
            self.points.push(Tied { node, place: Some(point), freedoms: Freedoms::NONE, hold: None });
        }
        for body in &self.frame.bodies {
            let Some(point) = body.points.first().and_then(|handle| self.frame.own(*handle, count)) else { continue };
            let centre = body.rigid.centre.map_or(self.place(point), D::in_plane);
            let node = self.points[point].node;
            self.bodies.push((node, centre));
            if [body.rigid.mass, body.rigid.inertia] != [0.0; 2] {
                self.nodes[node] = self.nodes[node].and_body(body.rigid.mass, body.rigid.inertia, centre);
            }
        }
    }

    /// A node for each point of a path.
    fn add_paths(&mut self) {
        for (path, motion) in motions(self.frame).into_iter().enumerate() {
            let name = called("path point", path, self.frame.paths[path].name.as_ref());
            let held = Freedoms::ALL.without(motion.unwrap_or(Freedoms::NONE));
            if motion.is_none() {
                self.fail(name.clone(), Mistake::Motions);
            }
            let node = self.add_node(Node::at([0.0; 2]).held(held), name, true);
            self.paths.push(node);
        }
    }

    /// The node of the ground.
    fn ground(&mut self) -> usize {
        let ground = self
            .ground
            .unwrap_or_else(|| self.add_node(Node::at([0.0; 2]).held(Freedoms::ALL), String::from("the ground"), true));
        self.ground = Some(ground);
        ground
    }

    fn join(&mut self, called: String, ends: [network::End<f64>; 2], element: impl Into<AnyMember<f64>>) {
        self.members.push(NetworkMember { ends, element: element.into() });
        self.called.push(called);
    }

    fn bring(&mut self, point: usize, freedoms: Freedoms) {
        self.brought[point] = self.brought[point].union(freedoms.intersection(D::FREEDOMS));
    }

    fn add_member(&mut self, index: usize, entry: &MemberEntry<D>) {
        let name = called("member", index, entry.name.as_ref());
        let element = match entry.member.element {
            Ok(element) => element,
            Err(mistake) => return self.fail(name, mistake),
        };
        let is_rigid = match element {
            AnyMember::Joint(joint) => joint.is_rigid(),
            AnyMember::DampedJoint(joint) => joint.is_rigid(),
            _ => false,
        };
        if is_rigid && element.freedoms() == D::FREEDOMS {
            return self.fail(name, Mistake::RigidHinge);
        }
        let ends = entry.ends.map(|end| end.releasing(entry.member.released));
        let joined = [0, 1].map(|end| self.joined(&ends[end], &ends[1 - end], element));
        match joined {
            [Ok(from), Ok(to)] => self.join(name, [from, to], element),
            [Err(mistake), _] | [_, Err(mistake)] => self.fail(name, mistake),
        }
    }

    /// The end of a member in the network, given its other end.
    fn joined(&mut self, end: &End<D>, other: &End<D>, element: AnyMember<f64>) -> Result<network::End<f64>, Mistake> {
        let freedoms = element.freedoms();
        let (is_joint, is_along) = (element.is_joint(), freedoms.is(Freedoms::X));
        let has_motion = freedoms.count() == 1 && !is_joint;
        // what acts along a direction has one at both ends, or leads from the one place to the other
        let between_places = [end, other].iter().all(|end| matches!(end.seat, Seat::Point(_)) && end.along.is_none());
        let along = match end.along.or_else(|| D::ACROSS.filter(|_| is_along)) {
            Some(direction) if !(is_along || is_joint) || !network::is_direction(direction) => {
                return Err(Mistake::Direction);
            }
            along => along,
        };
        let own = match end.seat {
            Seat::Point(handle) => {
                let point = self.frame.own(handle, self.frame.points.len()).ok_or(Mistake::OtherFrame)?;
                if is_along && along.is_none() && !between_places {
                    return Err(Mistake::NoDirection);
                }
                let (node, place) = (self.points[point].node, end.place.map_or(self.place(point), D::in_plane));
                let is_elsewhere = place != self.nodes[node].position;
                // where its point turns, an end beside it moves
                let arm = if place == self.place(point) { Freedoms::NONE } else { Freedoms::RZ };
                self.bring(point, brought_by(element).without(end.released.intersection(Freedoms::RZ)).union(arm));
                let joined = network::End::of(node).releasing(end.released);
                if is_elsewhere { joined.at(place) } else { joined }
            }
            _ if !has_motion => return Err(Mistake::NoPlace),
            Seat::Path(handle) => {
                let path = self.frame.own(handle, self.paths.len()).ok_or(Mistake::OtherFrame)?;
                network::End::of(self.paths[path])
            }
            Seat::Ground => network::End::of(self.ground()),
        };
        let of_path = !matches!(end.seat, Seat::Point(_)) && is_along;
        Ok(match if of_path { Some([1.0, 0.0]) } else { along } {
            Some(direction) => own.along(direction),
            None => own,
        })
    }

    /// A mass on the motion of a path, or on that of a point in a direction.
    fn add_mass(&mut self, on: &End<D>, mass: f64) {
        let part = String::from("a mass");
        match on.seat {
            Seat::Ground => self.fail(part, Mistake::NoPlace),
            Seat::Path(handle) => match self.frame.own(handle, self.paths.len()) {
                Some(path) => self.add_to_node(self.paths[path], mass),
                None => self.fail(part, Mistake::OtherFrame),
            },
            Seat::Point(handle) => {
                let Some(point) = self.frame.own(handle, self.frame.points.len()) else {
                    return self.fail(part, Mistake::OtherFrame);
                };
                self.bring(point, XY);
                let (node, place) = (self.points[point].node, on.place.map_or(self.place(point), D::in_plane));
                let Some(direction) = on.along.or(D::ACROSS) else {
                    self.nodes[node] = self.nodes[node].and_body(mass, 0.0, place);
                    return;
                };
                let held = Freedoms::ALL.without(Freedoms::X);
                let own = self.add_node(Node::at(place).held(held), part.clone(), true);
                self.add_to_node(own, mass);
                let ends = [network::End::of(own).along([1.0, 0.0]), network::End::of(node).at(place).along(direction)];
                self.join(part, ends, Joint::rigid(Freedoms::X));
            }
        }
    }

    /// Adds a mass to the motion of a path.
    fn add_to_node(&mut self, node: usize, mass: f64) {
        let turns = !self.nodes[node].held.contains(Freedoms::RZ);
        let Node { mass: own, inertia, .. } = self.nodes[node];
        self.nodes[node] = if turns {
            self.nodes[node].with_body(own, inertia + mass, [0.0; 2])
        } else {
            self.nodes[node].with_body(own + mass, inertia, self.nodes[node].position)
        };
    }

    /// A support holds the node of its point. A second one on a body holds another place of it, by a rigid joint with the ground.
    fn hold(&mut self, point: usize) {
        let hold = match self.frame.points[point].holds.as_slice() {
            [] => return,
            [hold] => *hold,
            _ => return self.fail(self.point_name(point), Mistake::HeldTwice),
        };
        let Tied { node, .. } = self.points[point];
        let place = self.place(point);
        let is_second = (0..point).any(|other| self.points[other].node == node && self.points[other].hold.is_some());
        let holding = if is_second {
            let name = self.point_name(point);
            let ground = self.add_node(Node::at(place).held(Freedoms::ALL), name.clone(), false);
            let freedoms = if hold.along.is_some() { hold.freedoms.union(Freedoms::Y) } else { hold.freedoms };
            let axis = hold.along.unwrap_or([1.0, 0.0]);
            let ends = [network::End::of(ground), network::End::of(node).at(place)].map(|end| end.along(axis));
            self.join(name, ends, Joint::rigid(freedoms));
            ground
        } else {
            let own = &mut self.nodes[node];
            (own.held, own.along) = (hold.freedoms, hold.along);
            node
        };
        let across = if hold.along.is_some() { XY } else { Freedoms::NONE };
        self.points[point].hold = Some(Hold { node: holding, freedoms: hold.freedoms.union(across) });
    }

    /// Holds what nothing brings to a node.
    fn settle(&mut self) {
        let mut of_nodes = vec![Freedoms::NONE; self.nodes.len()];
        for (tied, brought) in self.points.iter().zip(&self.brought) {
            of_nodes[tied.node] = of_nodes[tied.node].union(*brought);
        }
        for tied in &mut self.points {
            tied.freedoms = of_nodes[tied.node];
        }
        for tied in &self.points {
            let node = &mut self.nodes[tied.node];
            // across a direction it is held already
            let of_direction = if node.along.is_some() { XY } else { Freedoms::NONE };
            node.held = node.held.union(Freedoms::ALL.without(of_nodes[tied.node]).without(of_direction));
        }
        if self.frame.members.is_empty() {
            self.fail(String::from("the frame"), Mistake::Empty);
        }
    }
}

/// The freedoms that an element brings to a point.
fn brought_by(element: AnyMember<f64>) -> Freedoms {
    let freedoms = element.freedoms();
    match freedoms.contains(Freedoms::RZ) {
        true if freedoms.is(Freedoms::RZ) && !element.is_joint() => Freedoms::RZ,
        // joints share what they tie, and what they let go moves on both sides
        true => Freedoms::ALL,
        false => XY,
    }
}

//! The nodes and members of a frame: points that bodies tie are one node, supports hold it, paths have nodes of their own.

use crate::elements::any_member::AnyMember;
use crate::elements::rotor_member::RotorMember;
use crate::frame::bodies::is_mass;
use crate::frame::dimension::Dimension;
use crate::frame::ends::{End, Seat};
use crate::frame::entries::{Frame, MemberEntry};
use crate::frame::error::{BuildError, Mistake};
use crate::frame::parts::{Parts, is_one_direction};
use crate::frame::paths::motions;
use crate::model::{Tied, definite};
use crate::pass::network::{self, Part, PlacedNode, SpatialEnd};
use mstmm_plan::{Freedoms, freedoms_in_part};
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

/// A part of a member of the network that a frame is.
pub(crate) type NetworkPart = Part<RotorMember<f64>>;

/// The nodes and members of a frame.
pub(crate) struct Assembly<'f, D: Dimension> {
    pub(super) frame: &'f Frame<D>,
    pub(crate) nodes: Vec<PlacedNode<f64>>,
    /// What each node is called: of points the first one, of paths the point of a path.
    pub(crate) names: Vec<String>,
    pub(crate) is_of_path: Vec<bool>,
    pub(crate) parts: Vec<NetworkPart>,
    /// What the member of each part is called, and which of its parts it is: its index, and the parameters that its section names.
    pub(crate) called: Vec<(String, usize, u32)>,
    /// The first part of each member of the frame, and behind the last one.
    pub(crate) first_parts: Vec<usize>,
    /// The points of the frame, by their nodes.
    pub(crate) points: Vec<Tied>,
    /// The node and the mass centre of each body.
    pub(crate) bodies: Vec<(usize, [f64; 3])>,
    /// The bodies that spin, each with the part of its gyroscopic moment.
    pub(crate) discs: Vec<(usize, usize)>,
    /// The freedoms that members and bodies bring to each point.
    brought: Vec<Freedoms>,
    pub(super) paths: Vec<usize>,
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
            parts: Vec::new(),
            called: Vec::new(),
            first_parts: Vec::new(),
            points: Vec::new(),
            bodies: Vec::new(),
            discs: Vec::new(),
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
        for (index, member) in frame.members.iter().enumerate() {
            assembly.first_parts.push(assembly.parts.len());
            assembly.add_member(index, member);
        }
        assembly.first_parts.push(assembly.parts.len());
        frame.masses.iter().for_each(|mass| assembly.add_mass(&mass.on, mass.mass));
        assembly.spin_discs();
        (0..frame.points.len()).for_each(|point| assembly.hold(point));
        assembly.settle();
        assembly
    }

    pub(crate) fn fail(&mut self, part: String, mistake: Mistake) {
        self.errors.push(BuildError { part, mistake });
    }

    pub(super) fn point_name(&self, point: usize) -> String {
        called("point", point, self.frame.points[point].name.as_ref())
    }

    pub(super) fn place(&self, point: usize) -> [f64; 3] {
        D::in_space(self.frame.points[point].place)
    }

    pub(super) fn add_node(&mut self, node: PlacedNode<f64>, name: String, is_of_path: bool) -> usize {
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
            let brought = if body.rigid.turns { Freedoms::SPACE } else { Freedoms::DISPLACEMENTS };
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
                self.add_node(PlacedNode::at(place), self.point_name(point), false)
            });
            nodes[class] = Some(node);
            self.points.push(Tied { node, place: Some(point), freedoms: Freedoms::NONE, hold: None });
        }
        for (index, body) in self.frame.bodies.iter().enumerate() {
            let Some(point) = body.points.first().and_then(|handle| self.frame.own(*handle, count)) else { continue };
            let centre = body.rigid.centre.map_or(self.place(point), D::in_space);
            let node = self.points[point].node;
            self.bodies.push((node, centre));
            if !(is_mass(body.rigid.mass) && centre.iter().all(|part| part.is_finite())) {
                self.fail(called("body", index, body.name.as_ref()), Mistake::Mass);
                continue;
            }
            if body.rigid.mass == 0.0 && body.rigid.inertia == [0.0; 6] {
                continue;
            }
            match definite(body.rigid.inertia) {
                Some(inertia) => self.nodes[node] = self.nodes[node].and_body(body.rigid.mass, inertia, centre),
                None => {
                    let is_tensor = D::FREEDOMS == Freedoms::SPACE;
                    let mistake = if is_tensor { Mistake::Tensor } else { Mistake::Mass };
                    self.fail(called("body", index, body.name.as_ref()), mistake);
                }
            }
        }
    }

    /// A node for each point of a path.
    fn add_paths(&mut self) {
        for (path, motion) in motions(self.frame).into_iter().enumerate() {
            let name = called("path point", path, self.frame.paths[path].name.as_ref());
            // on a line that along a path is that of its points
            let along =
                motion.map(|motion| if motion.is(Freedoms::X) && D::ACROSS.is_some() { Freedoms::Y } else { motion });
            let held = Freedoms::SPACE.without(along.unwrap_or(Freedoms::NONE));
            if motion.is_none() {
                self.fail(name.clone(), Mistake::Motions);
            }
            let node = self.add_node(PlacedNode::at([0.0; 3]).held(held), name, true);
            self.paths.push(node);
        }
    }

    /// The node of the ground.
    pub(super) fn ground(&mut self) -> usize {
        let ground = self.ground.unwrap_or_else(|| {
            self.add_node(PlacedNode::at([0.0; 3]).held(Freedoms::SPACE), String::from("the ground"), true)
        });
        self.ground = Some(ground);
        ground
    }

    /// Joins two ends by the parts of a member.
    ///
    /// # Errors
    /// [`Mistake::NoOrientation`] where it leads along its `up`.
    pub(super) fn join(&mut self, called: &str, ends: [SpatialEnd<f64>; 2], parts: &Parts) -> Result<(), Mistake> {
        let vector = |end: &SpatialEnd<f64>| {
            let place = |end: &SpatialEnd<f64>| end.place.unwrap_or(self.nodes[end.node].position);
            let [from, to] = ends.each_ref().map(place);
            end.along.unwrap_or(if parts.is_joint() { [1.0, 0.0, 0.0] } else { [0, 1, 2].map(|k| to[k] - from[k]) })
        };
        let along = vector(&ends[0]);
        let is_known = network::is_direction(along);
        let mut planes = Vec::new();
        for (part, element) in parts.iter() {
            let plane = parts.plane::<D>(part, if is_known { Some(along) } else { None })?;
            planes.push((part, element, plane));
        }
        for (part, element, plane) in planes {
            let ends = ends.map(|end| SpatialEnd { released: freedoms_in_part(part, end.released), ..end });
            self.parts.push(NetworkPart { ends, plane, element });
            self.called.push((String::from(called), part, parts.named));
        }
        Ok(())
    }

    pub(super) fn bring(&mut self, point: usize, freedoms: Freedoms) {
        self.brought[point] = self.brought[point].union(freedoms.intersection(D::FREEDOMS));
    }

    fn add_member(&mut self, index: usize, entry: &MemberEntry<D>) {
        let name = called("member", index, entry.name.as_ref());
        let parts = match entry.member.parts {
            Ok(parts) => parts,
            Err(mistake) => return self.fail(name, mistake),
        };
        let is_rigid = parts.iter().all(|(_, element)| match element {
            RotorMember::Standing(AnyMember::Joint(joint)) => joint.is_rigid(),
            RotorMember::Standing(AnyMember::DampedJoint(joint)) => joint.is_rigid(),
            _ => false,
        });
        if is_rigid && parts.freedoms() == D::FREEDOMS {
            return self.fail(name, Mistake::RigidHinge);
        }
        let ends = entry.ends.map(|end| end.releasing(entry.member.released));
        let ends = match self.of_one_axis(ends, &parts) {
            Ok(ends) => ends,
            Err(mistake) => return self.fail(name, mistake),
        };
        let joined = [0, 1].map(|end| self.joined(&ends[end], &ends[1 - end], &parts));
        let failed = match joined {
            [Ok(from), Ok(to)] => {
                self.join(&name, [from, to], &parts.without_twist([from.released, to.released])).err()
            }
            [Err(mistake), _] | [_, Err(mistake)] => Some(mistake),
        };
        failed.into_iter().for_each(|mistake| self.fail(name.clone(), mistake));
    }

    /// The ends of a joint, both with the direction that one of them has.
    ///
    /// # Errors
    /// [`Mistake::TwoAxes`] where they have two, [`Mistake::OnePoint`] where a joint has nothing to join.
    fn of_one_axis(&self, ends: [End<D>; 2], parts: &Parts) -> Result<[End<D>; 2], Mistake> {
        if !parts.is_joint() {
            return Ok(ends);
        }
        let node = |end: &End<D>| match end.seat {
            Seat::Point(handle) => self.frame.own(handle, self.points.len()).map(|point| self.points[point].node),
            _ => None,
        };
        if node(&ends[0]).is_some() && node(&ends[0]) == node(&ends[1]) {
            return Err(Mistake::OnePoint);
        }
        let axis = ends[0].along.or(ends[1].along);
        if let [Some(one), Some(other)] = ends.map(|end| end.along)
            && !is_one_direction(one, other)
        {
            return Err(Mistake::TwoAxes);
        }
        Ok(ends.map(|end| End { along: axis, turns: ends.iter().any(|end| end.turns), ..end }))
    }

    /// The end of a member in the network, given its other end.
    fn joined(&mut self, end: &End<D>, other: &End<D>, parts: &Parts) -> Result<SpatialEnd<f64>, Mistake> {
        let (is_joint, motion) = (parts.is_joint(), parts.motion());
        let (is_along, turns) = (motion == Some(Freedoms::X), motion == Some(Freedoms::RZ));
        // in the plane all turns about z
        let turns_about = turns && D::FREEDOMS == Freedoms::SPACE;
        if end.along.is_some() && end.turns != turns_about && (is_along || turns || is_joint) {
            return Err(if turns && !turns_about { Mistake::Direction } else { Mistake::WrongWay });
        }
        // what acts along a direction has one at both ends, or leads from the one place to the other
        let between_places = [end, other].iter().all(|end| matches!(end.seat, Seat::Point(_)) && end.along.is_none());
        let along = match end.along.or_else(|| D::ACROSS.filter(|_| is_along)) {
            Some(direction) if !(is_along || is_joint || turns_about) || !network::is_direction(direction) => {
                return Err(Mistake::Direction);
            }
            along => along,
        };
        let own = match end.seat {
            Seat::Point(handle) => {
                let point = self.frame.own(handle, self.frame.points.len()).ok_or(Mistake::OtherFrame)?;
                if along.is_none() && (is_along && !between_places || turns_about) {
                    return Err(if turns_about { Mistake::NoAxis } else { Mistake::NoDirection });
                }
                let (node, place) = (self.points[point].node, end.place.map_or(self.place(point), D::in_space));
                let is_elsewhere = place != self.nodes[node].position;
                // where its point turns, an end beside it moves
                let arm = if place == self.place(point) { Freedoms::NONE } else { Freedoms::ROTATIONS };
                // rotations come together, unless the end lets go of all that the member has
                let own = parts.freedoms().intersection(Freedoms::ROTATIONS);
                let let_go = if end.released.contains(own) { Freedoms::ROTATIONS } else { Freedoms::NONE };
                self.bring(point, parts.brought::<D>().without(let_go).union(arm));
                SpatialEnd { node, place: is_elsewhere.then_some(place), along: None, released: end.released }
            }
            _ if motion.is_none() => return Err(Mistake::NoPlace),
            Seat::Path(handle) => {
                let path = self.frame.own(handle, self.paths.len()).ok_or(Mistake::OtherFrame)?;
                at_node(self.paths[path])
            }
            Seat::Ground => at_node(self.ground()),
        };
        // the motion of a path is that along x, on a line along y, or about z, of its node
        let of_path = match end.seat {
            Seat::Point(_) => None,
            _ if is_along => Some(D::ACROSS.unwrap_or([1.0, 0.0, 0.0])),
            _ => turns_about.then_some([0.0, 0.0, 1.0]),
        };
        Ok(SpatialEnd { along: of_path.or(along), ..own })
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
            // displacements of a skew node are held as its direction says
            let of_direction = if node.skew.is_some() { Freedoms::DISPLACEMENTS } else { Freedoms::NONE };
            node.held = node.held.union(Freedoms::SPACE.without(of_nodes[tied.node]).without(of_direction));
        }
        if self.frame.members.is_empty() {
            self.fail(String::from("the frame"), Mistake::Empty);
        }
    }
}

/// An end at a node, in its axes.
pub(super) fn at_node(node: usize) -> SpatialEnd<f64> {
    SpatialEnd { node, place: None, along: None, released: Freedoms::NONE }
}

//! What a plane structure does in one motion.

use crate::element::MemberEnds;
use crate::model::{
    EndMotion, Handle, Hold, MemberPlane, MotionError, PlaneEntry, PlanePoint, Quantity, Site, SpreadLoad, Tied,
};
use crate::number::Frequency;
use crate::pass::network::vector::{ROTATIONS, Six, at_node, difference, displacements, moved, rotations};
use crate::pass::network::{ActingLoad, NetworkMotion, PerNode, Placed, longest, size_on_node};
use core::ops::Range;
use mstmm_plan::Freedoms;

/// The displacements and forces of a plane structure in one motion.
#[derive(Debug)]
pub struct PlaneStates<'a, Y: Placed, S: Frequency<Y::Parameter>> {
    pub(crate) system: &'a Y,
    pub(crate) x: S,
    pub(crate) motion: NetworkMotion<Y, S>,
    /// The load of a response.
    pub(crate) load: Option<ActingLoad<S>>,
}

impl<Y: Placed, S: Frequency<Y::Parameter>> Clone for PlaneStates<'_, Y, S> {
    fn clone(&self) -> Self {
        PlaneStates { motion: self.motion.clone(), ..*self }
    }
}

impl<'a, Y: Placed, S: Frequency<Y::Parameter>> PlaneStates<'a, Y, S> {
    /// A quantity at a point: a displacement, an internal force, a reaction.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a node or a member that this system has not got; [`MotionError::NoSuchFreedom`] for a motion or a force
    /// that no element brings to this point, such as the moment of a spring.
    pub fn value(&self, entry: PlaneEntry<Y::Model>) -> Result<S, MotionError> {
        check(self.system, entry)?;
        match entry.quantity {
            Quantity::Displacement(site, axis) => Ok(self.displacements(site)?[axis]),
            Quantity::Reaction(site, axis) => {
                Ok(self.all_reactions(held_at::<Y, S>(self.system, site, axis)?.0)?[axis])
            }
            Quantity::Internal { member, end, force } => {
                let part = internal(self.system, member, force)?;
                let own = self.member(part)?[end].internal(end)[force % 3];
                // the second part turns about -y
                Ok(if force == MOMENT_Y { -own } else { own })
            }
        }
    }

    /// Displacements \[m\], \[m\], \[rad\] and forces \[N\], \[N\], [N m] of both ends of a member, along it, across it and of the rotation.
    /// The forces act on the member.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a member that this system has not got.
    pub fn member(&self, member: usize) -> Result<&[EndMotion<S>; 2], MotionError> {
        let members = &self.motion.members.as_ref()[..self.system.sizes()[1]];
        members.get(member).ok_or(MotionError::NoSuchPoint { index: member })
    }

    /// The frequency and the motions of both ends of a member.
    #[doc(hidden)]
    pub fn member_ends(&self, member: usize) -> MemberEnds<S> {
        MemberEnds { x: self.x, ends: self.motion.members.as_ref()[member] }
    }

    /// Displacements x \[m\], y \[m\] and the rotation about z \[rad\] of a node.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a node that this system has not got.
    pub fn node(&self, node: usize) -> Result<[S; 3], MotionError> {
        self.all_of(node).map(|[x, y, turn, ..]| [x, y, turn])
    }

    /// The displacements of a point, or of the end of a member, along x, y and z \[m\] and its rotations about them \[rad\]; zero where no element
    /// brings the motion.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a point or a member that this system has not got.
    pub fn motion_of(&self, point: impl Into<PlanePoint<Y::Model>>) -> Result<[S; 6], MotionError> {
        let site = point.into().site;
        let mut own = self.displacements(site)?;
        for (axis, value) in own.iter_mut().enumerate() {
            match check_freedom(self.system, site, axis) {
                Err(MotionError::NoSuchFreedom { .. }) => *value = S::zero(),
                known => known?,
            }
        }
        let ([x, y, z], [about_x, about_y, about_z]) = (displacements(own), rotations(own));
        Ok([x, y, z, about_x, about_y, about_z])
    }

    /// All displacements of a node.
    pub(crate) fn all_of(&self, node: usize) -> Result<Six<S>, MotionError> {
        let nodes = &self.motion.nodes.as_ref()[..self.system.sizes()[0]];
        nodes.get(node).copied().ok_or(MotionError::NoSuchPoint { index: node })
    }

    /// The forces x \[N\], y \[N\] and the moment [N m] of its support on a node; zero to rounding in the motions that no support holds.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a node that this system has not got.
    pub fn reaction(&self, node: usize) -> Result<[S; 3], MotionError> {
        let [x, y, about_z, ..] = self.all_reactions(node)?;
        Ok([x, y, about_z])
    }

    /// What its support does to a node.
    fn all_reactions(&self, node: usize) -> Result<Six<S>, MotionError> {
        self.all_of(node)?;
        Ok(self.reactions().as_ref()[node])
    }

    /// The load along members under which this motion is.
    pub(super) fn spread(&self) -> Option<SpreadLoad> {
        match self.load? {
            ActingLoad::Spread(load) => Some(load),
            ActingLoad::At(_) | ActingLoad::Jump(_) => None,
        }
    }

    /// The node with which a point moves.
    pub(super) fn node_of(&self, point: PlanePoint<Y::Model>) -> Result<usize, MotionError> {
        Ok(match located(self.system, point.site)? {
            Seen::Tied(Tied { node, .. }) => node,
            Seen::End { parts, end } => self.system.placement(parts.start).node_of(end),
        })
    }

    /// What is along a member, across it and about it in the axes of the structure.
    pub(super) fn in_global_axes(&self, member: usize, end: usize, vector: [S; 3]) -> Six<S> {
        self.system.placement(member).axes::<S>(end).back(vector)
    }

    /// The displacements of a point.
    fn displacements(&self, site: Site) -> Result<Six<S>, MotionError> {
        match located(self.system, site)? {
            Seen::Tied(Tied { node, place, .. }) => Ok(moved(self.all_of(node)?, offset(self.system, node, place))),
            Seen::End { parts, end } if self.system.placement(parts.start).plane() == MemberPlane::Structure => {
                let member = parts.start;
                let own = self.member(member)?[end].displacements;
                let placement = self.system.placement(member);
                let mut local = self.tied(member, end);
                for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
                    if placement.released(end).contains(kind) {
                        local[freedom] = own[freedom];
                    }
                }
                Ok(self.in_global_axes(member, end, local))
            }
            Seen::End { parts, end } => {
                let placement = self.system.placement(parts.start);
                let mut sum = moved(self.all_of(placement.node_of(end))?, placement.offset(end));
                for member in parts {
                    let (own, tied) = (self.member(member)?[end].displacements, self.tied(member, end));
                    let mut jump = [S::zero(); 3];
                    for (freedom, kind) in Freedoms::SINGLE.into_iter().enumerate() {
                        if self.system.placement(member).released(end).contains(kind) {
                            jump[freedom] = own[freedom] - tied[freedom];
                        }
                    }
                    let jump = self.in_global_axes(member, end, jump);
                    sum.iter_mut().zip(jump).for_each(|(own, part)| *own += part);
                }
                Ok(sum)
            }
        }
    }

    /// The displacements of the place of the end of a member, as its node has them, in the axes of the member.
    pub(super) fn tied(&self, member: usize, end: usize) -> [S; 3] {
        let placement = self.system.placement(member);
        placement.tied(end, self.motion.nodes.as_ref()[placement.node_of(end)])
    }

    /// The largest sum of forces on the motions of a node, and the largest force of a member or of the inertia of a body; a moment counts by the
    /// longest member.
    pub(super) fn imbalance(&self) -> [f64; 2] {
        let nodes = self.system.sizes()[0];
        let length = longest(self.system);
        let size = |forces: &Six<S>| size_on_node(forces, length);
        let mut largest = self.motion.largest_force(length);
        let mut worst = 0.0_f64;
        let reactions = self.reactions();
        let of_nodes = self.motion.nodes.as_ref().iter().zip(reactions.as_ref());
        for (node, (displacements, reaction)) in of_nodes.enumerate().take(nodes) {
            for (row, displacement) in self.inertia(node).iter().zip(displacements) {
                largest = largest.max(size(&row.map(|entry| entry * *displacement)));
            }
            let motions = self.system.node(node).1;
            worst = worst.max(size(&motions.displacements(motions.parts_of(*reaction))));
        }
        [worst, largest]
    }

    /// The size of the largest displacement or rotation of a node; a rotation counts by the longest member.
    pub(super) fn largest_motion(&self) -> f64 {
        let length = longest(self.system);
        let nodes = &self.motion.nodes.as_ref()[..self.system.sizes()[0]];
        nodes.iter().map(|node| size_on_node(node, 1.0 / length)).fold(0.0, f64::max)
    }

    /// λ² times the mass matrix of the body of a node.
    fn inertia(&self, node: usize) -> [Six<S>; 6] {
        let lambda_squared = self.x.lambda_squared();
        self.system.node(node).0.mass_matrix::<S>().map(|row| row.map(|entry| lambda_squared * entry))
    }

    /// What supports do to their nodes: the inertia of bodies less the forces of members and the load.
    pub(super) fn reactions(&self) -> PerNode<Y, Six<S>> {
        let [nodes, members] = self.system.sizes();
        let mut reactions = self.system.per_node([S::zero(); 6]);
        let sums = reactions.as_mut();
        for (node, (sum, displacements)) in sums.iter_mut().zip(self.motion.nodes.as_ref()).enumerate().take(nodes) {
            for (entry, row) in sum.iter_mut().zip(self.inertia(node)) {
                for (part, displacement) in row.iter().zip(displacements) {
                    *entry += *part * *displacement;
                }
            }
        }
        for (member, ends) in self.motion.members.as_ref()[..members].iter().enumerate() {
            let placement = self.system.placement(member);
            for (end, motion) in ends.iter().enumerate() {
                let forces = at_node(self.in_global_axes(member, end, motion.forces), placement.offset::<S>(end));
                let sum = &mut sums[placement.node_of(end)];
                sum.iter_mut().zip(forces).for_each(|(entry, force)| *entry += force);
            }
        }
        if let Some(load) = self.load {
            for (node, sum) in reactions.as_mut().iter_mut().enumerate().take(nodes) {
                let forces = load.on_node(self.system, node);
                for (entry, force) in sum.iter_mut().zip(forces.into_iter().flatten()) {
                    *entry -= force;
                }
            }
        }
        reactions
    }
}

/// Whether a structure has what an entry asks for.
pub(super) fn check<Y: Placed>(system: &Y, entry: PlaneEntry<Y::Model>) -> Result<(), MotionError> {
    match entry.quantity {
        Quantity::Displacement(site, axis) => check_freedom(system, site, axis),
        Quantity::Reaction(site, axis) => held_at::<Y, Y::Parameter>(system, site, axis).map(|_| ()),
        Quantity::Internal { member, force, .. } => internal(system, member, force).map(|_| ()),
    }
}

/// The place of the moment about y among the internal forces of a member in space.
pub(super) const MOMENT_Y: usize = 5;

/// The freedoms of a member whose forces are its internal forces, part by part.
const INTERNAL: [Freedoms; 9] = [
    Freedoms::X,
    Freedoms::Y,
    Freedoms::RZ,
    Freedoms::X,
    Freedoms::Z,
    Freedoms::RY,
    Freedoms::X,
    Freedoms::Y,
    Freedoms::RX,
];

/// The part of a member that has an internal force.
///
/// # Errors
/// [`MotionError::NoSuchFreedom`] where none has; as [`Placed::member_of`] besides.
pub(super) fn internal<Y: Placed>(system: &Y, member: Handle, force: usize) -> Result<usize, MotionError> {
    let of_part = Freedoms::SINGLE[force % 3];
    let part = system.part_of(member, force / 3)?.filter(|part| system.placement(*part).freedoms.contains(of_part));
    part.ok_or(MotionError::NoSuchFreedom { freedom: INTERNAL[force] })
}

/// Where a point is in a structure.
pub(super) enum Seen {
    /// At a place that a node ties rigidly.
    Tied(Tied),
    /// Where a member of some parts ends.
    End { parts: Range<usize>, end: usize },
}

/// Where a point is in a structure.
///
/// # Errors
/// [`MotionError::NoSuchPoint`] and [`MotionError::OtherFrame`] for a point that this structure has not got.
pub(super) fn located<Y: Placed>(system: &Y, site: Site) -> Result<Seen, MotionError> {
    let tied = match site {
        Site::End { member, end } => return Ok(Seen::End { parts: system.parts_of(member)?, end }),
        Site::Point(point) => system.point(point)?,
        Site::Tied(tied) => tied,
    };
    // a sketch of another size
    if tied.node >= system.sizes()[0] {
        return Err(MotionError::NoSuchPoint { index: tied.node });
    }
    Ok(Seen::Tied(tied))
}

/// Whether elements bring a motion to a point.
pub(super) fn check_freedom<Y: Placed>(system: &Y, site: Site, axis: usize) -> Result<(), MotionError> {
    let freedom = Freedoms::EACH[axis];
    match located(system, site)? {
        Seen::Tied(Tied { freedoms, .. }) if !freedoms.contains(freedom) => Err(MotionError::NoSuchFreedom { freedom }),
        Seen::Tied(_) => Ok(()),
        Seen::End { mut parts, .. } => {
            let is_in_plane = system.placement(parts.start).plane() == MemberPlane::Structure;
            // an end moves as its point does, and turns where the member does
            let turns = ROTATIONS.contains(&axis);
            let is_there = !turns || parts.any(|part| system.placement(part).freedoms.contains(Freedoms::RZ));
            let is_beyond = is_in_plane && !Freedoms::PLANE.contains(freedom);
            if is_there && !is_beyond { Ok(()) } else { Err(MotionError::NoSuchFreedom { freedom }) }
        }
    }
}

/// The node that a support holds along an axis, and what a displacement of 1 of the support moves it by.
///
/// # Errors
/// [`MotionError::NotHeld`] where nothing holds the point so; [`MotionError::NoSuchPoint`] for a node that this system has not got.
pub(super) fn held_at<Y: Placed, S: Frequency<Y::Parameter>>(
    system: &Y,
    site: Site,
    axis: usize,
) -> Result<(usize, Six<S>), MotionError> {
    let freedom = Freedoms::EACH[axis];
    let not_held = MotionError::NotHeld { freedom };
    let hold = match located(system, site)? {
        Seen::Tied(tied) => tied.hold,
        Seen::End { .. } => None,
    };
    let Hold { node, .. } = hold.filter(|hold| hold.freedoms.contains(freedom)).ok_or(not_held)?;
    Ok((node, system.node(node).0.moved(axis).ok_or(not_held)?))
}

/// Where a place is from the node that ties it; none is its own.
pub(super) fn offset<Y: Placed, S: Frequency<Y::Parameter>>(system: &Y, node: usize, place: Option<usize>) -> [S; 3] {
    let Some(place) = place else { return [S::zero(); 3] };
    let (to, from) = (system.place(place), system.node(node).0.position);
    difference(from.map(S::from_parameter), to.map(S::from_parameter))
}

//! The motion of a plane structure under a load.

use crate::answer::network::spread_load::loads;
use crate::answer::network::states::{MOMENT_Y, PlaneStates, Seen, check_freedom, held_at, internal, located, offset};
use crate::answer::root::is_below_losses;
use crate::model::{EndMotion, MemberPlane, MotionError, PlaneActing, PlaneLoad, Site, SpreadLoad, Tied};
use crate::number::Frequency;
use crate::pass::characteristic::System;
use crate::pass::network::vector::{ROTATIONS, at_node, difference, displacements};
use crate::pass::network::{
    ActingLoad, JumpAt, LoadAt, Loading, MovingNetwork, NetworkMotion, PerMember, Placed, PlaneFrequency, Wanted,
    load_on_chart, motion_under,
};
use mstmm_plan::Freedoms;
use num_traits::{One, Zero};

/// Where a resonance is not looked for again, as a part of its frequency.
const ELSEWHERE: f64 = 0.617;

/// A structure under a harmonic load.
#[derive(Debug)]
pub(super) struct UnderLoad<'a, Y: Placed> {
    pub(super) system: &'a Y,
    pub(super) load: PlaneLoad<Y::Model>,
}

impl<Y: Placed> Clone for UnderLoad<'_, Y> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Y: Placed> Copy for UnderLoad<'_, Y> {}

impl<'a, Y: Placed> UnderLoad<'a, Y> {
    /// A structure under a load that it takes.
    pub(super) fn new(system: &'a Y, load: PlaneLoad<Y::Model>) -> Result<Self, MotionError> {
        acting_at::<Y, Y::Parameter>(system, load.acting)?;
        Ok(UnderLoad { system, load })
    }

    /// The force on a node and where it acts from there; none where the load is none, or a moment.
    pub(super) fn force_on(&self, node: usize) -> Result<Option<[[Y::Parameter; 3]; 2]>, MotionError> {
        match self.load.acting {
            PlaneActing::Force(site, axis) => {
                let (own, from) = site_of::<Y, Y::Parameter>(self.system, site, axis)?;
                let mut forces = [Y::Parameter::zero(); 6];
                forces[axis] = Y::Parameter::one();
                Ok((own == node).then_some([displacements(forces), from]))
            }
            PlaneActing::Spread(SpreadLoad { member: None, .. }) => {
                let acting = acting_at::<Y, Y::Parameter>(self.system, self.load.acting)?;
                let body = self.system.node(node).0;
                let forces = acting.on_node(self.system, node);
                Ok(forces.map(|forces| [displacements(forces), difference(body.position, body.centre)]))
            }
            _ => Ok(None),
        }
    }

    /// Logarithm to base 2 of a frequency below all roots but those at zero.
    pub(super) fn lowest_exponent(&self) -> i32 {
        self.system.frequency_estimates().lowest_exponent()
    }

    /// The displacements and forces that are wanted.
    pub(super) fn states<S>(&self, x: S, wanted: Wanted) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        if is_below_losses(self.system, x) {
            return Err(MotionError::LossFactor);
        }
        self.continued(x, wanted)
    }

    /// The displacements and forces that are wanted at a frequency, with a loss factor below the real axis as above it.
    pub(super) fn continued<S>(&self, x: S, wanted: Wanted) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let load = acting_at::<Y, S>(self.system, self.load.acting)?;
        let motion = self.motion(x, load, wanted)?;
        let frequency = x.modulus();
        if !(x.lambda_squared().size().is_finite() && (motion.vanished_at.is_some() || motion.is_finite())) {
            return Err(MotionError::NotFinite { frequency });
        }
        match motion.vanished_at {
            None => Ok(PlaneStates { system: self.system, x, motion, load: Some(load) }),
            Some(node) if self.vanishes_elsewhere(x, load)? => {
                Err(MotionError::Mechanism { at: self.system.spot(node as usize) })
            }
            Some(_) => Err(MotionError::Resonance { frequency }),
        }
    }

    /// The motion under the load: computed in extended precision, where there is one.
    fn motion<S>(&self, x: S, load: ActingLoad<S>, wanted: Wanted) -> Result<NetworkMotion<Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        if !S::HAS_EXTENDED {
            return self.motion_at_speed(x, load, wanted);
        }
        let along = self.along_members(load)?;
        let own = |member: usize, chart: &_| {
            load_on_chart((self.system, x), (member, along.as_ref()[member]), chart, S::from_extended, S::to_extended)
        };
        let load = acting_at::<Y, S::Extended>(self.system, self.load.acting)?;
        Ok(motion_under(self.system, x.to_extended(), &Loading::Acting(load, &own), wanted).rounded(S::from_extended))
    }

    /// Whether something vanishes at another frequency, too, far from one: then it does at all.
    #[cold]
    fn vanishes_elsewhere<S>(&self, x: S, load: ActingLoad<S>) -> Result<bool, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let low = S::from_extended(S::steady(self.lowest_exponent()));
        let other = if x.is_zero() { low } else { x * S::from_f64(ELSEWHERE) };
        Ok(self.motion(other, load, Wanted::Nodes)?.vanished_at.is_some())
    }

    /// The displacements and forces that are wanted, in the numbers of the model.
    pub(super) fn states_at_speed<S>(&self, x: S, wanted: Wanted) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        if is_below_losses(self.system, x) {
            return Err(MotionError::LossFactor);
        }
        let load = acting_at::<Y, S>(self.system, self.load.acting)?;
        let motion = self.motion_at_speed(x, load, wanted)?;
        if motion.vanished_at.is_some() {
            return Err(MotionError::Resonance { frequency: x.modulus() });
        }
        Ok(PlaneStates { system: self.system, x, motion, load: Some(load) })
    }

    /// The motion under the load, in the numbers of the model.
    fn motion_at_speed<S>(&self, x: S, load: ActingLoad<S>, wanted: Wanted) -> Result<NetworkMotion<Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let along = self.along_members(load)?;
        let same = |number: S| number;
        let own = |member: usize, chart: &_| {
            load_on_chart((self.system, x), (member, along.as_ref()[member]), chart, same, same)
        };
        Ok(motion_under(self.system, x, &Loading::Acting(load, &own), wanted))
    }

    /// The load along each member.
    fn along_members<S>(&self, load: ActingLoad<S>) -> Result<PerMember<Y, [S; 2]>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        match load {
            ActingLoad::Spread(spread) => loads::<Y, S>(self.system, spread),
            ActingLoad::At(_) | ActingLoad::Jump(_) => Ok(self.system.per_member([S::zero(); 2])),
        }
    }
}

/// A load where it acts: on a node.
pub(super) fn acting_at<Y: Placed, S: Frequency<Y::Parameter>>(
    system: &Y,
    load: PlaneActing,
) -> Result<ActingLoad<S>, MotionError> {
    let mut forces = [S::zero(); 6];
    let (site, axis) = match load {
        PlaneActing::Spread(load) => {
            load.member.map_or(Ok(0), |member| system.member_of(member))?;
            if ROTATIONS.contains(&load.axis) {
                return Err(MotionError::NoSuchFreedom { freedom: Freedoms::EACH[load.axis] });
            }
            return Ok(ActingLoad::Spread(load));
        }
        PlaneActing::Dislocation(member, end, force) => {
            let (member, freedom) = (internal(system, member, force)?, force % 3);
            // what a rigid joint ties is one motion of both nodes
            if system.placement(member).is_tie {
                return Err(MotionError::NoSuchFreedom { freedom: Freedoms::SINGLE[freedom] });
            }
            let by = S::from_f64(EndMotion::<S>::dislocation(end, freedom));
            let by = if force == MOMENT_Y { -by } else { by };
            return Ok(ActingLoad::Jump(JumpAt { member, end, freedom, by }));
        }
        PlaneActing::Motion(site, axis) => {
            check_freedom(system, site, axis)?;
            let (node, moved) = held_at(system, site, axis)?;
            return Ok(ActingLoad::At(LoadAt { node, forces, moved: Some(moved) }));
        }
        PlaneActing::Force(site, axis) => (site, axis),
    };
    let (node, offset) = site_of(system, site, axis)?;
    forces[axis] = S::one();
    Ok(ActingLoad::At(LoadAt { node, forces: at_node(forces, offset), moved: None }))
}

/// The node on which a force along an axis acts, or a moment about one, and where it acts from there.
fn site_of<Y: Placed, S: Frequency<Y::Parameter>>(
    system: &Y,
    site: Site,
    axis: usize,
) -> Result<(usize, [S; 3]), MotionError> {
    check_freedom(system, site, axis)?;
    match located(system, site)? {
        Seen::Tied(Tied { node, place, .. }) => Ok((node, offset(system, node, place))),
        Seen::End { parts, end } => {
            // a force acts on what the end shares with its node
            let of_kind = if ROTATIONS.contains(&axis) { Freedoms::RZ } else { Freedoms::X.union(Freedoms::Y) };
            let placement = system.placement(parts.start);
            for part in parts {
                let released = system.placement(part).released(end).intersection(of_kind);
                if !released.is_empty() {
                    let is_in_plane = placement.plane() == MemberPlane::Structure;
                    return Err(MotionError::NoSuchFreedom {
                        freedom: if is_in_plane { released } else { Freedoms::EACH[axis] },
                    });
                }
            }
            Ok((placement.node_of(end), placement.offset(end)))
        }
    }
}

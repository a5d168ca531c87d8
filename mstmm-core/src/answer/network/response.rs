//! Responses of plane structures to harmonic loads.

use crate::answer::at_rest::{AtRest, Part};
use crate::answer::facts::Facts;
use crate::answer::frequency_response::on_grid;
use crate::answer::network::spread_load::loads;
use crate::answer::network::states::{
    MOMENT_Y, PlaneStates, Seen, check, check_freedom, held_at, internal, located, offset,
};
use crate::answer::response_curve::{Sample, refined};
use crate::answer::root::{Root, is_below_losses};
use crate::model::{
    EndMotion, MemberPlane, MotionError, PlaneActing, PlaneEntry, PlaneLoad, Quantity, SpreadLoad, Tied,
};
use crate::number::{Frequency, List};
use crate::pass::characteristic::System;
use crate::pass::network::vector::{ROTATIONS, at_node};
use crate::pass::network::{
    ActingLoad, JumpAt, LoadAt, Loading, MovingNetwork, NetworkMotion, PerMember, Placed, PlaneFrequency, Wanted,
    load_on_chart, motion_under,
};
use crate::search::ClosedRange;
use mstmm_plan::Freedoms;
use num_traits::{One, Zero};

/// Where a resonance is not looked for again, as a part of its frequency.
const ELSEWHERE: f64 = 0.617;

/// A transfer function of a plane structure: a displacement, an internal force or a reaction per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct PlaneResponse<'a, Y: Placed> {
    system: &'a Y,
    load: PlaneLoad<Y::Model>,
    entry: PlaneEntry<Y::Model>,
}

impl<Y: Placed> Clone for PlaneResponse<'_, Y> {
    fn clone(&self) -> Self {
        PlaneResponse { ..*self }
    }
}

impl<'a, Y: Placed> PlaneResponse<'a, Y> {
    pub(super) fn new(
        system: &'a Y,
        load: PlaneLoad<Y::Model>,
        entry: PlaneEntry<Y::Model>,
    ) -> Result<Self, MotionError> {
        acting_at::<Y, Y::Parameter>(system, load.acting)?;
        check(system, entry)?;
        Ok(PlaneResponse { system, load, entry })
    }

    /// What its load and its entry are.
    pub(crate) fn facts(&self) -> Facts<Y::Parameter> {
        let is_motion = matches!(self.load.acting, PlaneActing::Motion(..) | PlaneActing::Dislocation(..));
        let displaced = match self.entry.quantity {
            Quantity::Displacement(_, axis) => Some(axis),
            Quantity::Internal { .. } | Quantity::Reaction(..) => None,
        };
        let along = match self.load.acting {
            PlaneActing::Spread(SpreadLoad { axis, is_inertia: true, .. }) => {
                Some(if displaced == Some(axis) { Y::Parameter::one() } else { Y::Parameter::zero() })
            }
            _ => None,
        };
        Facts { along, ..Facts::of(self.system, is_motion, displaced.is_none()) }
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration; at 0 that to a load at rest, with
    /// loss factors the limit from above.
    ///
    /// It is computed in extended precision, where the numbers of the model have one. Where a part of the structure is not held
    /// and the load does not move it off, the limit at rest is extrapolated from some tens to hundreds of responses at low frequencies, to 12
    /// digits of the largest of these.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::Mechanism`] where nothing holds a part without mass,
    /// [`MotionError::Unsettled`] for an uncertain limit at rest, [`MotionError::NotFinite`] where numbers overflow.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let frequency = x.modulus();
        let wanted = self.wanted()?;
        let value = match self.states_for(x, wanted) {
            Err(MotionError::Resonance { .. }) if x.is_zero() => self.limit_at_rest()?,
            // below the real axis a motion has the conjugate loss factor; that of a rotor is one of the other whirl
            Err(MotionError::LossFactor) if !const { Y::SPINS } => {
                self.states_for(x.conjugate(), wanted)?.value(self.entry)?.conjugate()
            }
            states => states?.value(self.entry)?,
        };
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency }) }
    }

    /// The response in the numbers of the model, for control loops and others that count each microsecond: it takes a third of the time of
    /// [`at`](PlaneResponse::at), or less.
    ///
    /// It loses as many digits as the ratio of the stiffnesses that meet has: of 16 there are 8 left where one is 1e8 times as stiff as another, and
    /// beside a resonance those that the distance takes. Nothing tells how many; `at` loses none.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), and [`MotionError::Resonance`] at rest where a part of the structure is not held.
    pub fn at_speed<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        if is_below_losses(self.system, x) {
            return Err(MotionError::LossFactor);
        }
        let load = acting_at::<Y, S>(self.system, self.load.acting)?;
        let motion = self.motion_at_speed(x, load, self.wanted()?)?;
        if motion.vanished_at.is_some() {
            return Err(MotionError::Resonance { frequency: x.modulus() });
        }
        let value = PlaneStates { system: self.system, x, motion, load: Some(load) }.value(self.entry)?;
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency: x.modulus() }) }
    }

    /// Of which members the entry needs the motions.
    fn wanted(&self) -> Result<Wanted, MotionError> {
        Ok(match self.entry.quantity {
            Quantity::Displacement(site, _) => match located(self.system, site)? {
                Seen::Tied(_) => Wanted::Nodes,
                Seen::End { parts, .. } if parts.len() > 1 => Wanted::All,
                Seen::End { parts, .. } => Wanted::Member(parts.start),
            },
            Quantity::Internal { member, force, .. } => Wanted::Member(internal(self.system, member, force)?),
            Quantity::Reaction(..) => Wanted::All,
        })
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

    /// The limit at rest of a structure of which a part is not held.
    #[cold]
    fn limit_at_rest<S>(&self) -> Result<S, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let rest = AtRest::of::<<Y as System>::Parameter>(self.lowest_exponent(), 0.0, |x| self.sized(x))?;
        let moves_off = !(rest.double.is_zero() && rest.simple.is_zero());
        if moves_off { Err(MotionError::Resonance { frequency: 0.0 }) } else { Ok(rest.finite) }
    }

    /// The response, and a size compared with which its rounding is small: the largest displacement, or the largest force.
    pub(super) fn sized<S>(&self, x: S) -> Result<Part<S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        let states = self.states(x)?;
        let value = states.value(self.entry)?;
        let size = match self.entry.quantity {
            Quantity::Displacement(..) => states.motion.size(),
            Quantity::Reaction(..) | Quantity::Internal { .. } => states.motion.largest_force(1.0),
        };
        let size = value.size().max(size);
        if const { Y::SPINS } || self.system.frequency_estimates().has_loss() {
            return Ok(Part { value, size, mirrored: self.continued(-x, Wanted::All)?.value(self.entry)? });
        }
        Ok(Part::new(value, size))
    }

    /// Logarithm to base 2 of a frequency below all roots but those at zero.
    pub(super) fn lowest_exponent(&self) -> i32 {
        self.system.frequency_estimates().lowest_exponent()
    }

    /// The response over a range of ω [rad/s], refined where it bends: between two samples it differs from the straight line at the middle by
    /// no more than `tolerance` times the largest of the three.
    ///
    /// `roots` are the roots whose resonances may lie in the range: none of them is missed, however narrow. Undamped resonances are infinite
    /// and are approached to 1e-4 of the range.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `CAP` samples; [`MotionError::Range`] for a range that is empty, reversed or not finite;
    /// [`MotionError::Tolerance`] for a tolerance that is not positive; else as [`at`](PlaneResponse::at).
    pub fn curve<const CAP: usize, S>(
        &self,
        range: impl ClosedRange<Y::Parameter>,
        roots: &[impl Root<Y::Parameter, Frequency = S>],
        tolerance: f64,
    ) -> Result<List<Sample<Y::Parameter, S>, CAP>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        refined(|x| self.at(x), &range.closed(), roots.iter().map(Root::peak), tolerance)
    }

    /// All displacements and forces at a frequency.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), and [`MotionError::LossFactor`] for `Im λ < 0` where something has a loss factor.
    pub fn states<S>(&self, x: S) -> Result<PlaneStates<'a, Y, S>, MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        self.states_for(x, Wanted::All)
    }

    /// The displacements and forces that are wanted.
    fn states_for<S>(&self, x: S, wanted: Wanted) -> Result<PlaneStates<'a, Y, S>, MotionError>
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
    fn continued<S>(&self, x: S, wanted: Wanted) -> Result<PlaneStates<'a, Y, S>, MotionError>
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

    /// Writes the responses at the frequencies of `grid` to `values`.
    ///
    /// # Errors
    /// As [`at`](PlaneResponse::at), for the first frequency where it fails; [`MotionError::Capacity`] where `values` is shorter than
    /// `grid`.
    pub fn on<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: MovingNetwork<S>,
        S: PlaneFrequency<<Y as System>::Parameter>,
    {
        on_grid(|x| self.at(x), grid, values)
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
    check_freedom(system, site, axis)?;
    let (node, offset): (_, [S; 3]) = match located(system, site)? {
        Seen::Tied(Tied { node, place, .. }) => (node, offset(system, node, place)),
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
            (placement.node_of(end), placement.offset(end))
        }
    };
    forces[axis] = S::one();
    Ok(ActingLoad::At(LoadAt { node, forces: at_node(forces, offset), moved: None }))
}

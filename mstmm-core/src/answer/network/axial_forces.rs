//! Axial forces from loads at rest: what they are in each member, and the structure under them.
//!
//! Forces N along members of a structure at rest work on small rotations of these: `½ ∫ N Y'²`. So they are parameters of beams and strings, `axial_force` and `tension`, to which
//! the forces under loads are added. What a spring, a rod or a rigid link would add has no parameter: a structure in which they carry axial forces is refused.

use crate::answer::network::levers::Levers;
use crate::answer::network::under_load::UnderLoad;
use crate::model::{
    AxialForceError, InvalidParameter, MemberLabel, MotionError, ParameterError, PlaneLoad, Requirement,
};
use crate::number::{Parameter, Real};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, PerMember, Placed, PlaneFrequency, Prestressed, Wanted};
use core::ops::Mul;
use num_complex::Complex;
use num_traits::Zero;

/// Rounding of forces at rest, in units of the largest force of the structure: each is right to some of these, and what is less is none.
const ROUNDING: f64 = 64.0;

/// Steps from forces to the forces in the structure under them. Each leaves a part of the change before: half of it where the load is half the critical one.
const STEPS: usize = 64;

/// The axial forces \[N\] of the members of a structure, tension positive; of a load along a member the mean of both ends.
///
/// They are proportional to their loads: `&forces * 2.0` are those of twice the loads.
#[derive(Debug)]
pub struct AxialForces<'a, Y: Placed> {
    system: &'a Y,
    forces: PerMember<Y, Y::Parameter>,
}

impl<Y: Placed> Clone for AxialForces<'_, Y> {
    fn clone(&self) -> Self {
        AxialForces { system: self.system, forces: self.forces.clone() }
    }
}

impl<'a, Y: Placed> Mul<Y::Parameter> for &AxialForces<'a, Y> {
    type Output = AxialForces<'a, Y>;

    fn mul(self, factor: Y::Parameter) -> AxialForces<'a, Y> {
        let mut product = self.clone();
        product.forces.as_mut().iter_mut().for_each(|force| *force *= factor);
        product
    }
}

impl<Y: Placed> AxialForces<'_, Y> {
    /// The axial force of a member \[N\], tension positive.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] and [`MotionError::OtherFrame`] for a member that the structure has not got.
    pub fn get<E>(&self, member: MemberLabel<Y::Model, E>) -> Result<Y::Parameter, MotionError> {
        let member = self.system.member_of(member.handle())?;
        self.forces.as_ref().get(member).copied().ok_or(MotionError::NoSuchPoint { index: member })
    }

    /// Of each member.
    fn all(&self) -> impl Iterator<Item = (usize, Y::Parameter)> + '_ {
        self.forces.as_ref().iter().copied().enumerate().take(self.system.sizes()[1])
    }

    /// The largest difference to other forces.
    fn change(&self, other: &Self) -> f64 {
        let pairs = self.all().zip(other.all());
        pairs.map(|((_, one), (_, other))| (one - other).to_f64().abs()).fold(0.0, f64::max)
    }

    /// The size of the largest force.
    fn largest(&self) -> f64 {
        self.all().map(|(_, force)| force.to_f64().abs()).fold(0.0, f64::max)
    }
}

/// The axial forces under loads, each with its value.
pub(super) fn axial_forces<'a, Y, T>(
    system: &'a Y,
    loads: &[(PlaneLoad<Y::Model>, T)],
) -> Result<AxialForces<'a, Y>, AxialForceError>
where
    T: Real,
    Y: Prestressed + System<Parameter = T> + MovingNetwork<Complex<T>>,
    Complex<T>: PlaneFrequency<T>,
{
    if system.frequency_estimates().has_loss() {
        return Err(MotionError::LossFactor.into());
    }
    let mut forces = system.per_member(T::zero());
    let mut levers = Levers::new(system);
    for (load, value) in loads {
        let under = UnderLoad::new(system, *load)?;
        let states = under.states(Complex::zero(), Wanted::All)?;
        for (member, sum) in forces.as_mut().iter_mut().enumerate().take(system.sizes()[1]) {
            let ends = states.member(member)?;
            // of a member in space the first part stretches
            if system.placement(member).part() == 0 && !is_in_path(system, member) {
                let [from, to] = [0, 1].map(|end| ends[end].internal(end)[0].re);
                *sum += *value * T::from_f64(0.5) * (from + to);
            }
        }
        levers.add(&under, &states, *value)?;
    }
    let least = ROUNDING * T::EPSILON * levers.largest_force();
    forces.as_mut().iter_mut().filter(|force| force.size() <= least).for_each(|force| *force = T::zero());
    for first in 0..system.sizes()[1] {
        let force = forces.as_ref()[first];
        system.parts_from(first).for_each(|part| forces.as_mut()[part] = force);
    }
    levers.check()?;
    let forces = AxialForces { system, forces };
    check_members(&forces)?;
    Ok(forces)
}

/// Whether a member stands in a path of one motion, which has no axial force.
fn is_in_path<Y: Placed>(system: &Y, member: usize) -> bool {
    let placement = system.placement(member);
    [0, 1].iter().any(|end| system.node(placement.node_of(*end)).1.has_no_direction())
}

/// Checks that all members that carry axial forces have a parameter for it, or need none: what stands at one place has no length, and what has directions of its own
/// does not turn.
fn check_members<Y, T>(forces: &AxialForces<'_, Y>) -> Result<(), AxialForceError>
where
    T: Real,
    Y: Prestressed + System<Parameter = T>,
{
    let mut trial = forces.system.clone();
    for (member, force) in forces.all().filter(|(_, force)| !force.is_zero()) {
        let placement = forces.system.placement(member);
        let turns = [0, 1].iter().any(|end| placement.along(*end).is_none()) && !placement.own_length().is_zero();
        // a force out of range is an error of the structure under it
        if turns && trial.add_axial_force(member, force.words()) == Some(Ok(false)) {
            let (member, name) = forces.system.called(member);
            return Err(AxialForceError::NoAxialForce { member, name, force: force.to_f64() });
        }
    }
    Ok(())
}

/// The structure under axial forces besides those that its members have.
pub(super) fn with_axial_forces<Y: Prestressed>(system: &Y, forces: &AxialForces<'_, Y>) -> Result<Y, ParameterError> {
    let mut own = system.clone();
    let are_own = forces.system.sizes() == system.sizes();
    for (member, force) in forces.all().filter(|(_, force)| !force.is_zero()) {
        let borne = own.add_axial_force(member, force.words()).filter(|_| are_own);
        let of_other = InvalidParameter {
            parameter: "axial_force",
            value: force.to_f64(),
            requirement: Requirement::SameStructure,
        };
        borne.unwrap_or(Err(of_other)).map_err(|error| error.of(system.called(member).1))?;
    }
    own.describe();
    Ok(own)
}

/// The structure under the axial forces that loads have in it, as it is under these.
pub(super) fn settled_under<Y, T>(system: &Y, loads: &[(PlaneLoad<Y::Model>, T)]) -> Result<Y, AxialForceError>
where
    T: Real,
    Y: Prestressed + System<Parameter = T> + MovingNetwork<Complex<T>>,
    Complex<T>: PlaneFrequency<T>,
{
    let mut forces = axial_forces(system, loads)?;
    let mut change = f64::INFINITY;
    for _ in 0..STEPS {
        let loaded = with_axial_forces(system, &forces)?;
        let next = AxialForces { system, forces: axial_forces(&loaded, loads)?.forces };
        let last = core::mem::replace(&mut change, next.change(&forces));
        let is_exact = change <= ROUNDING * T::EPSILON * next.largest();
        forces = next;
        if is_exact {
            return Ok(with_axial_forces(system, &forces)?);
        }
        if change.is_nan() || change > last {
            break;
        }
    }
    Err(AxialForceError::Unsettled { change })
}

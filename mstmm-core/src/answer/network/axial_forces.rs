//! Axial forces from loads at rest: what they are in each member, and the structure under them.
//!
//! Forces N along members of a structure at rest work on small rotations of these: `½ ∫ N Y'²`. So they are parameters of beams and strings, `axial_force` and `tension`, to which
//! the forces under loads are added. What a spring, a rod, a rigid link or a slider would add has no parameter: a structure in which they carry axial forces is refused.

use crate::answer::network::carried::Carried;
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

/// Change of forces, in roundings of the largest one, that is none; and as a part of that below which a change that does not fall is rounding.
const ROUNDING: f64 = 64.0;
const SETTLED: f64 = 1e-9;

/// Steps from forces to the forces in the structure under them. Each leaves a part of the change before.
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

impl<'a, Y: Placed> Mul<Y::Parameter> for AxialForces<'a, Y> {
    type Output = AxialForces<'a, Y>;

    fn mul(self, factor: Y::Parameter) -> AxialForces<'a, Y> {
        &self * factor
    }
}

impl<'a, Y: Placed<Parameter = f64>> Mul<&AxialForces<'a, Y>> for f64 {
    type Output = AxialForces<'a, Y>;

    fn mul(self, forces: &AxialForces<'a, Y>) -> AxialForces<'a, Y> {
        forces * self
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
    let mut carried = Carried::new(system);
    for (index, (load, value)) in loads.iter().enumerate() {
        if !value.size().is_finite() {
            return Err(AxialForceError::Load { index, value: value.to_f64() });
        }
        let under = UnderLoad::new(system, *load)?;
        carried.add(&under, &under.states(Complex::zero(), Wanted::All)?, *value)?;
    }
    carried.check_levers()?;
    carried.check_slides()?;
    let mut forces = system.per_member(T::zero());
    for (member, own) in forces.as_mut().iter_mut().enumerate().take(system.sizes()[1]) {
        // of a member in space the first part stretches
        *own = carried.axial(member);
    }
    if !forces.as_ref().iter().all(|force| force.size().is_finite()) {
        return Err(MotionError::NotFinite { frequency: 0.0 }.into());
    }
    for first in 0..system.sizes()[1] {
        let force = forces.as_ref()[first];
        system.parts_from(first).for_each(|part| forces.as_mut()[part] = force);
    }
    let forces = AxialForces { system, forces };
    check_members(&forces)?;
    Ok(forces)
}

/// Whether a member stands in a path of one motion, which has no axial force.
fn is_in_path<Y: Placed>(system: &Y, member: usize) -> bool {
    let placement = system.placement(member);
    [0, 1].iter().any(|end| system.node(placement.node_of(*end)).1.has_no_direction())
}

/// Whether a member needs a parameter for an axial force: what stands at one place has no length, and what has directions of its own does not turn. The force of a path has the
/// direction of its places, which turns.
fn needs_parameter<Y: Placed>(system: &Y, member: usize) -> bool {
    let placement = system.placement(member);
    let turns = [0, 1].iter().any(|end| placement.along(*end).is_none()) && !placement.own_length().is_zero();
    turns || is_in_path(system, member)
}

/// Checks that all members that carry axial forces have a parameter for it.
fn check_members<Y, T>(forces: &AxialForces<'_, Y>) -> Result<(), AxialForceError>
where
    T: Real,
    Y: Prestressed + System<Parameter = T>,
{
    let mut trial = forces.system.clone();
    for (member, force) in forces.all().filter(|(_, force)| !force.is_zero()) {
        // a force out of range is an error of the structure under it
        let bears =
            !is_in_path(forces.system, member) && trial.add_axial_force(member, force.words()) != Some(Ok(false));
        if needs_parameter(forces.system, member) && !bears {
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
        let of_other = InvalidParameter {
            parameter: "axial_force",
            value: force.to_f64(),
            requirement: Requirement::SameStructure,
        };
        let bears = own.add_axial_force(member, force.words()).filter(|_| are_own).unwrap_or(Err(of_other));
        let is_borne =
            bears.and_then(|bears| if bears || !needs_parameter(system, member) { Ok(()) } else { Err(of_other) });
        is_borne.map_err(|error| error.of(system.called(member).1))?;
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
        let largest = next.largest();
        forces = next;
        // near a critical load rounding is all that still changes
        let rests = change <= SETTLED * largest && change >= 0.5 * last;
        if rests || change <= ROUNDING * T::EPSILON * largest {
            return Ok(with_axial_forces(system, &forces)?);
        }
    }
    Err(AxialForceError::Unsettled { change })
}

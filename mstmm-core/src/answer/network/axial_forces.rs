//! Axial forces from loads at rest: what they are in each member, and the structure under them.
//!
//! Forces N along members of a structure at rest work on small rotations of these: `½ ∫ N Y'²`. So they are parameters of beams and strings, `axial_force` and `tension`, to which
//! the forces under loads are added. What a spring, a rod, a rigid link or a slider would add has no parameter: a structure in which they carry axial forces is refused.

use crate::answer::network::carried::Carried;
use crate::answer::network::spread_load::is_in_path;
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

/// Roundings of the largest force below which forces do not change: two of each of some tens of products and sums of a sway.
const ROUNDING: f64 = 64.0;

/// Part of the largest force below which a change that does not fall any more is rounding: a structure with 1e-7 left of its stiffness amplifies it so far.
const SETTLED: f64 = 1e-9;

/// Steps from forces to those in the structure under them. A step that leaves three quarters of a change needs as many for eight digits.
const STEPS: usize = 64;

/// The axial forces \[N\] of the members of a structure, tension positive; of a load along a member the mean of both ends.
///
/// Forces are proportional to their loads: `&forces * 2.0` are the forces of twice the loads.
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

/// The axial forces under loads, each load with its value.
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
    for first in 0..system.sizes()[1] {
        // of a member in space the first part stretches, and all parts bear its force
        let force = carried.axial(first);
        if !force.size().is_finite() {
            return Err(MotionError::NotFinite { frequency: 0.0 }.into());
        }
        system.parts_from(first).for_each(|part| forces.as_mut()[part] = force);
    }
    let forces = AxialForces { system, forces };
    check_members(&forces)?;
    Ok(forces)
}

/// Whether a member needs a parameter for an axial force. A joint has no length, and a spring in a direction of its own does not turn with its ends. A path turns with its places.
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
            let (at, name) = (forces.system.spot_of_member(member), forces.system.name_of_member(member));
            return Err(AxialForceError::NoAxialForce { member: at, name, force: force.to_f64() });
        }
    }
    Ok(())
}

/// The structure whose members have further axial forces.
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
        is_borne.map_err(|error| error.of(system.name_of_member(member)))?;
    }
    own.describe();
    Ok(own)
}

/// The structure with its axial forces of second order under loads.
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

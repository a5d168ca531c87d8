//! The mass of a plane structure, or of one in space, that modes can move.

use crate::answer::network::about::{About, moving_inertia};
use crate::answer::network::spread_load::{loads, mass_per_length};
use crate::model::{Direction, MotionError, SpreadLoad};
use crate::number::{Oscillation, Real};
use crate::pass::characteristic::System;
use crate::pass::network::vector::Six;
use crate::pass::network::{Placed, PlacedMotions, mass_of_bodies};

/// The mass that modes can move along a direction: of members what they have along it, of bodies what nothing holds.
///
/// # Errors
/// As for the weight along it; [`MotionError::HeldMass`] for a body that something holds in part.
pub(super) fn moving_mass<Y, T>(system: &Y, direction: Direction<Y::Model>) -> Result<T, MotionError>
where
    T: Real + Oscillation<T>,
    Y: Placed + PlacedMotions<T> + System<Parameter = T>,
{
    if let Some(about) = About::of(direction) {
        return moving_inertia(system, &about);
    }
    let weight = SpreadLoad { member: None, axis: direction.axis, is_inertia: false };
    let weights = loads::<Y, T>(system, weight)?;
    let of_members = weights.as_ref().iter().enumerate().take(system.sizes()[1]);
    let along: Six<T> = core::array::from_fn(|axis| if axis == direction.axis { T::one() } else { T::zero() });
    of_members.fold(mass_of_bodies(system, |_| along), |sum, (member, [along, across])| {
        let mass = mass_per_length::<Y, T>(system, member);
        if mass.is_zero() {
            return sum;
        }
        Ok(sum? + (*along * *along + *across * *across) / mass * system.placement(member).length::<T>())
    })
}

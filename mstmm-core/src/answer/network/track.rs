//! Tracks of moving loads in plane structures: straight chains of members, and deflections along them.

use crate::answer::moving_load::load::{MovingLoad, TrackMode};
use crate::answer::moving_load::wave_sum::WaveSum;
use crate::answer::network::of_frame::for_each_shape;
use crate::answer::network::shape::PlaneShape;
use crate::answer::network::states::{PlaneStates, check};
use crate::answer::network::under_load::UnderLoad;
use crate::element::{Deflection, MemberEnds, MemberMotion, VisitMember};
use crate::model::{
    Handle, MemberPlane, MotionError, NotATrack, PlaneActing, PlaneEntry, PlaneLoad, Quantity, TrackError,
};
use crate::number::{Oscillation, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::vector::{difference, norm, unit};
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency, Wanted};
use crate::search::NaturalFrequency;
use mstmm_plan::Freedoms;
use num_traits::Zero;

/// Rounding of places, as a part of the length of a member, and of directions.
const ROUNDING: f64 = 1e-9;

/// The load that moves along members, with the modes of some roots.
pub(super) fn moving_load<'r, const N: usize, const M: usize, Y>(
    system: &Y,
    roots: impl IntoIterator<Item = &'r NaturalFrequency<Y::Parameter>>,
    members: [Handle; M],
    entry: PlaneEntry<Y::Model>,
) -> Result<MovingLoad<Y::Parameter, N, M>, TrackError>
where
    <Y as System>::Parameter: PlaneFrequency<<Y as System>::Parameter> + 'r,
    Y: MovingNetwork<<Y as System>::Parameter>,
{
    let members = track(system, members)?;
    let lengths = members.map(|member| system.placement(member).own_length());
    let line = influence_line(system, &members, entry)?;
    let mut load = MovingLoad::new(line, lengths);
    for root in roots {
        if root.omega.is_zero() {
            return Err(MotionError::ZeroFrequency.into());
        }
        let mut shapes = Ok(());
        let each = |shape: &PlaneShape<'_, Y, Y::Parameter>| {
            let value = shape.value(entry)?;
            match deflections(shape, &members) {
                Ok(own) => load.push(TrackMode::new(root.omega, load.roots, value, own))?,
                Err(error) => shapes = Err(error),
            }
            Ok(Y::Parameter::zero())
        };
        for_each_shape::<N, _, _, _>(system, root, each, &mut |_| Ok(()))?;
        shapes?;
        load.roots += 1;
    }
    Ok(load)
}

/// The influence line of an entry along members: the deflection at rest under the load that works with it. A reaction works against the motion of its support.
fn influence_line<const M: usize, Y>(
    system: &Y,
    members: &[usize; M],
    entry: PlaneEntry<Y::Model>,
) -> Result<[WaveSum<Y::Parameter>; M], TrackError>
where
    <Y as System>::Parameter: PlaneFrequency<<Y as System>::Parameter>,
    Y: MovingNetwork<<Y as System>::Parameter>,
{
    check(system, entry)?;
    let (load, sign) = match (entry.dual(), entry.quantity) {
        (None, Quantity::Reaction(site, axis)) => (PlaneLoad::new(PlaneActing::Motion(site, axis)), -1.0),
        (dual, _) => (dual.ok_or(MotionError::NotModal)?, 1.0),
    };
    let under = UnderLoad::new(system, load)?.states(Y::Parameter::zero(), Wanted::All)?;
    let line = deflections(&under, members)?;
    Ok(line.map(|member| member.times(Y::Parameter::from_f64(sign))))
}

/// The members of a straight chain.
fn track<const M: usize, Y: Placed>(system: &Y, members: [Handle; M]) -> Result<[usize; M], TrackError> {
    if M == 0 {
        return Err(TrackError::NoMembers);
    }
    let mut chain = [0; M];
    for (place, member) in members.into_iter().enumerate() {
        chain[place] = system.member_of(member)?;
        let own = system.placement(chain[place]);
        let wrong = |reason| TrackError::NotATrack { place, reason };
        let has_direction = [0, 1].iter().any(|end| own.along(*end).is_some());
        let moves_across = own.freedoms.contains(Freedoms::Y) && !own.is_tie;
        if own.plane() != MemberPlane::Structure || has_direction || !moves_across {
            return Err(wrong(NotATrack::NotAcross));
        }
        let Some(before) = place.checked_sub(1) else { continue };
        let before = system.placement(chain[before]);
        let between = |from: [Y::Parameter; 3], to| norm(difference(from, to)).size();
        if between(before.place_of(1), own.place_of(0)) > ROUNDING * own.own_length().size() {
            return Err(wrong(NotATrack::Apart));
        }
        if between(unit(before.vector(1)), unit(own.vector(0))) > ROUNDING {
            return Err(wrong(NotATrack::Turned));
        }
    }
    Ok(chain)
}

/// The deflections of a motion along members.
fn deflections<const M: usize, Y>(
    states: &PlaneStates<'_, Y, Y::Parameter>,
    members: &[usize; M],
) -> Result<[WaveSum<Y::Parameter>; M], TrackError>
where
    <Y as System>::Parameter: PlaneFrequency<<Y as System>::Parameter>,
    Y: MovingNetwork<<Y as System>::Parameter>,
{
    let mut all = [WaveSum::default(); M];
    for (place, (own, member)) in all.iter_mut().zip(members).enumerate() {
        let visitor = DeflectionOf(states.member_ends(*member));
        let deflection = states.system.visit_member(*member, visitor).flatten();
        let deflection = deflection.ok_or(TrackError::NoWaves { place })?;
        let frequency = states.x.modulus();
        *own = WaveSum::new(&deflection).ok_or(TrackError::Coincide { place, frequency })?;
    }
    Ok(all)
}

/// The deflection of a member with a motion of its ends.
struct DeflectionOf<S>(MemberEnds<S>);

impl<S: Scalar> VisitMember<S> for DeflectionOf<S> {
    type Output = Option<Deflection<S>>;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> Option<Deflection<S>> {
        E::deflection(built, &self.0)
    }
}

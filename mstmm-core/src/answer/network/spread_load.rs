//! Loads along members of plane structures.

use crate::answer::network::states::PlaneStates;
use crate::element::{MemberEnds, MemberMotion, VisitMember};
use crate::model::{EndMotion, MotionError, SpreadLoad};
use crate::number::{Oscillation, Scalar};
use crate::pass::network::{PerMember, Placed, PlacedMotions, load_work};
use mstmm_plan::Freedoms;
use num_traits::Zero;

/// The part of a load across a member that is its rounding.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// What a load along members is on each, along it and across it, per length.
///
/// # Errors
/// [`MotionError::NoUniformLoad`] where a member takes none, or a path of one motion has a mass, whose weight has no direction there;
/// [`MotionError::NoSuchFreedom`] for a direction in which a member does not move.
pub(super) fn loads<Y, S>(system: &Y, load: SpreadLoad) -> Result<PerMember<Y, [S; 2]>, MotionError>
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    let members = system.sizes()[1];
    let mut loads = system.per_member([S::zero(); 2]);
    if let Some(member) = load.member {
        for part in system.parts_of(member)? {
            loads.as_mut()[part] = on_member(system, load, part)?;
        }
        return Ok(loads);
    }
    let freedom = Freedoms::EACH[load.axis];
    if freedom.is(Freedoms::Z) && system.is_flat() {
        return Err(MotionError::NoSuchFreedom { freedom });
    }
    check_paths(system)?;
    for (member, own) in loads.as_mut().iter_mut().enumerate().take(members) {
        *own = on_member(system, load, member)?;
    }
    Ok(loads)
}

/// Checks that no path of one motion has a mass, whose weight has no direction.
///
/// # Errors
/// [`MotionError::NoUniformLoad`] where one has.
pub(super) fn check_paths<Y: Placed>(system: &Y) -> Result<(), MotionError> {
    let has_weight = |node: usize| {
        let (body, motions) = system.node(node);
        motions.has_no_direction() && body.has_body() && !body.mass.is_zero()
    };
    if (0..system.sizes()[0]).any(has_weight) { Err(MotionError::NoUniformLoad) } else { Ok(()) }
}

/// Whether a member stands in a path of one motion.
pub(super) fn is_in_path<Y: Placed>(system: &Y, member: usize) -> bool {
    let placement = system.placement(member);
    [0, 1].iter().any(|end| system.node(placement.node_of(*end)).1.has_no_direction())
}

/// Whether a member is a straight line between two places: it stands in no path and has one x axis at both ends.
pub(super) fn is_straight<Y: Placed>(system: &Y, member: usize) -> bool {
    let placement = system.placement(member);
    placement.axes::<Y::Parameter>(0).along == placement.axes(1).along && !is_in_path(system, member)
}

/// A load on a member, along it and across it, per length.
fn on_member<Y, S>(system: &Y, load: SpreadLoad, member: usize) -> Result<[S; 2], MotionError>
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    let density = match load.member {
        Some(loaded) => S::from_f64(if system.parts_of(loaded)?.contains(&member) { 1.0 } else { 0.0 }),
        None if load.is_inertia => -mass_per_length::<Y, S>(system, member),
        None => mass_per_length(system, member),
    };
    if density.is_zero() {
        return Ok([S::zero(); 2]);
    }
    let placement = system.placement(member);
    // a load does not twist
    if placement.part() == 2 {
        return Ok([S::zero(); 2]);
    }
    let takes_loads = system.visit_member(member, TakesLoads).unwrap_or(false);
    if !(is_straight(system, member) && takes_loads) {
        return Err(MotionError::NoUniformLoad);
    }
    let mut direction = [S::zero(); 6];
    direction[load.axis] = density;
    let [along, across, _] = placement.axes(0).of(direction);
    // of a member in space the first part takes what is along it
    let along = if placement.part() == 1 { S::zero() } else { along };
    for (part, freedom) in [(along, Freedoms::X), (across, Freedoms::Y)] {
        if part.size() > ROUNDING * density.size() && !placement.freedoms.contains(freedom) {
            return Err(MotionError::NoSuchFreedom { freedom });
        }
    }
    Ok([along, across])
}

impl<Y, S> PlaneStates<'_, Y, S>
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    /// The work of a load along members on this motion, without that of the bodies in a weight.
    pub(super) fn work_of(&self, load: SpreadLoad) -> Result<S, MotionError> {
        let loads = loads::<Y, S>(self.system, load)?;
        let members = loads.as_ref().iter().enumerate().take(self.system.sizes()[1]);
        Ok(members.fold(S::zero(), |sum, (member, load)| {
            sum + load_work(self.system, member, *load, self.member_ends(member))
        }))
    }

    /// The load along a member under which this motion is.
    pub(super) fn load_on(&self, member: usize) -> Option<[S; 2]> {
        on_member(self.system, self.spread()?, member).ok().filter(|load| load.iter().any(|part| !part.is_zero()))
    }
}

/// The mass per length of a member.
pub(super) fn mass_per_length<Y, S>(system: &Y, member: usize) -> S
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    system.visit_member(member, MassPerLength).unwrap_or_default()
}

struct MassPerLength;

impl<S: Scalar> VisitMember<S> for MassPerLength {
    type Output = S;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> S {
        E::mass_per_length(built)
    }
}

struct TakesLoads;

impl<S: Scalar> VisitMember<S> for TakesLoads {
    type Output = bool;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> bool {
        let resting = MemberEnds { x: S::zero(), ends: [EndMotion::at_rest(); 2] };
        E::load_work(built, &resting).is_some()
    }
}

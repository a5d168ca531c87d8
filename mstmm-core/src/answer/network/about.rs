//! The inertia of a plane structure, or of one in space, about an axis: of a shape, and of all that modes can move.
//!
//! A rotation e of the ground about a place moves each mass by `e × r`. It works on a shape with the deflection u and the rotation θ what the angular momentum is,
//! `∫ m e·(r × u) + ρI e·θ`: its factor of participation. That all modes together have is `∫ m (e × r)² + ρI`, along the directions in which each part moves.

use crate::answer::network::shape::PlaneShape;
use crate::answer::network::spread_load::{check_paths, is_straight, mass_per_length};
use crate::answer::network::states::PlaneStates;
use crate::element::{Inside, MemberNumbers};
use crate::model::{Direction, MemberPlane, MotionError, PlaneLoad};
use crate::number::gauss::integrals;
use crate::number::{Frequency, Oscillation, Parameter, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::network::vector::{ROTATIONS, Six, cross, difference, dot, six};
use crate::pass::network::{MovingNetwork, Placed, PlacedMotions, PlaneFrequency, mass_of_bodies};
use mstmm_plan::Freedoms;

/// The part of an arm that is its rounding: of three products and two sums for each of its parts, twice as much.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// An axis through a place.
#[derive(Clone, Copy)]
pub(super) struct About<T> {
    axis: [T; 3],
    place: [T; 3],
    freedom: Freedoms,
}

/// How far a rotation of 1 moves a part of a member along it and across it, at its input end and more per length, and turns it.
struct Arms<T> {
    along: T,
    across: T,
    across_per_length: T,
    turn: T,
}

impl<T: Real> About<T> {
    /// The axis of a direction; none of one along an axis.
    pub(super) fn of<M>(direction: Direction<M>) -> Option<Self> {
        let place = direction.about?.map(T::from_f64);
        let axis = ROTATIONS.map(|own| if own == direction.axis { T::one() } else { T::zero() });
        Some(About { axis, place, freedom: Freedoms::EACH[direction.axis] })
    }

    /// What a rotation of 1 moves a place by.
    fn rigid<S: Frequency<T>>(&self, at: [S; 3]) -> Six<S> {
        let (axis, place) = (self.axis.map(S::from_parameter), self.place.map(S::from_parameter));
        six(cross(axis, difference(place, at)), axis)
    }

    /// The arms of a part of a member.
    ///
    /// # Errors
    /// [`MotionError::NoUniformLoad`] for a member in a path, or with two x axes; [`MotionError::NoSuchFreedom`] for a member without the freedom in which the rotation moves it.
    fn arms<Y: Placed<Parameter = T>>(&self, system: &Y, member: usize) -> Result<Arms<T>, MotionError> {
        let placement = system.placement(member);
        if !is_straight(system, member) {
            return Err(MotionError::NoUniformLoad);
        }
        let axes = placement.axes::<T>(0);
        let from = difference(self.place, placement.place_of(0));
        let mut arms = Arms {
            along: dot(self.axis, cross(from, axes.along)),
            across: dot(self.axis, cross(from, axes.across)),
            across_per_length: dot(self.axis, cross(axes.along, axes.across)),
            turn: dot(self.axis, axes.normal),
        };
        if placement.part() == 1 {
            arms.along = T::zero();
        }
        if placement.part() == 2 || placement.plane() == MemberPlane::About {
            return Ok(Arms { along: T::zero(), across: T::zero(), across_per_length: T::zero(), ..arms });
        }
        let length = placement.own_length();
        let size = from.iter().fold(length.to_f64(), |size, part| size + part.to_f64().abs());
        let moves = [
            (arms.along, Freedoms::X),
            (arms.across, Freedoms::Y),
            (arms.across + arms.across_per_length * length, Freedoms::Y),
        ];
        for (arm, freedom) in moves {
            if arm.to_f64().abs() > ROUNDING * size && !placement.freedoms.contains(freedom) {
                return Err(MotionError::NoSuchFreedom { freedom: self.freedom });
            }
        }
        Ok(arms)
    }

    /// Checks that a structure turns about the axis.
    fn check<Y: Placed<Parameter = T>>(&self, system: &Y) -> Result<(), MotionError> {
        if !self.place.iter().all(|part| part.size().is_finite()) {
            return Err(MotionError::NotFinite { frequency: 0.0 });
        }
        if !self.freedom.is(Freedoms::RZ) && system.is_flat() {
            return Err(MotionError::NoSuchFreedom { freedom: self.freedom });
        }
        check_paths(system)
    }

    /// The mass per length of a part of a member, and its moment of inertia per length.
    fn inertias<Y, S>(system: &Y, member: usize) -> Result<[S; 2], MotionError>
    where
        S: Oscillation<T>,
        Y: PlacedMotions<S> + System<Parameter = T>,
    {
        let moment = match system.numbers()[member].parted().0 {
            MemberNumbers::Beam(beam) => beam.rotary_inertia,
            MemberNumbers::Line(2, line) | MemberNumbers::LineBetween(2, line) => line.inertia,
            MemberNumbers::Other => return Err(MotionError::NoUniformLoad),
            _ => [0.0; 2],
        };
        let is_twist = system.placement(member).plane() == MemberPlane::About;
        let mass = if is_twist { S::zero() } else { mass_per_length(system, member) };
        Ok([mass, S::from_parameter(T::of_words(moment))])
    }
}

/// The factor of participation of a shape along a direction, or about an axis.
pub(super) fn factor<Y, S>(shape: &PlaneShape<'_, Y, S>, direction: Direction<Y::Model>) -> Result<S, MotionError>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    match About::of(direction) {
        Some(about) => shape.momentum_about(&about),
        None => shape.work(PlaneLoad::weight(direction.axis)),
    }
}

/// The mass that modes can move about an axis [kg m²].
pub(super) fn moving_inertia<Y, T>(system: &Y, about: &About<T>) -> Result<T, MotionError>
where
    T: Real + Oscillation<T>,
    Y: Placed + PlacedMotions<T> + System<Parameter = T>,
{
    about.check(system)?;
    let mut sum = mass_of_bodies(system, |node| about.rigid(system.node(node).0.position))?;
    for member in 0..system.sizes()[1] {
        let [mass, moment] = About::inertias::<Y, T>(system, member)?;
        if mass.is_zero() && moment.is_zero() {
            continue;
        }
        let Arms { along, across, across_per_length, turn } = about.arms(system, member)?;
        let length = system.placement(member).own_length();
        let grown = across_per_length * length;
        let third = T::one() / T::from_f64(3.0);
        let squares = along * along + across * across + across * grown + grown * grown * third;
        sum += length * (mass * squares + moment * turn * turn);
    }
    Ok(sum)
}

impl<Y, S> PlaneStates<'_, Y, S>
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    /// The angular momentum about an axis [kg m²]: the factor of participation of a shape.
    pub(super) fn momentum_about(&self, about: &About<Y::Parameter>) -> Result<S, MotionError> {
        about.check(self.system)?;
        let mut sum = S::zero();
        for node in 0..self.system.sizes()[0] {
            let body = self.system.node(node).0;
            if body.has_body() {
                let rigid = about.rigid(body.position.map(S::from_parameter));
                sum += body.mass_form(rigid, self.all_of(node)?);
            }
        }
        for member in 0..self.system.sizes()[1] {
            let [mass, moment] = About::inertias::<Y, S>(self.system, member)?;
            if mass.is_zero() && moment.is_zero() {
                continue;
            }
            let arms = about.arms(self.system, member)?;
            let Inside { length, wave_number, .. } = self.inside(member)?;
            let number = S::from_parameter;
            let [own] = integrals(Y::Parameter::from_f64(length), wave_number * length, |distance: Y::Parameter| {
                let [along, across, turn] = self.motion_at(member, distance.to_f64()).displacements;
                let lever = arms.across + arms.across_per_length * distance;
                let moved = along * number(arms.along) + across * number(lever);
                [moved * mass + turn * (moment * number(arms.turn))]
            });
            sum += own;
        }
        Ok(sum)
    }
}

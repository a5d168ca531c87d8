//! Motions between the ends of members: states, nodes and the largest deflection.

use crate::answer::interior::{HALVINGS, sign_changes};
use crate::answer::network::states::PlaneStates;
use crate::element::{Inside, MemberEnds, MemberMotion, VisitMember};
use crate::model::{EndMotion, MemberLabel, MotionError};
use crate::number::{Oscillation, Real, Scalar};
use crate::pass::network::vector::displacements;
use crate::pass::network::{Placed, PlacedMotions};

/// Rounding of a length that follows from places, as a part of it.
const LENGTH: f64 = 64.0 * f64::EPSILON;

/// Part of the largest displacement of a member below which its deflection is rounding and crosses nothing.
const LEVEL: f64 = 1e-10;

/// The state of a cross section of a member: its displacements in global axes, and the forces inside of the member. In a plane structure all
/// that leads out of the plane is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberState<S> {
    /// The displacement along x \[m\].
    pub displacement_x: S,
    /// The displacement along y \[m\].
    pub displacement_y: S,
    /// The displacement along z \[m\].
    pub displacement_z: S,
    /// The rotation about x \[rad\], right-handed.
    pub rotation_x: S,
    /// The rotation about y \[rad\], right-handed.
    pub rotation_y: S,
    /// The rotation about z \[rad\], in the plane anticlockwise.
    pub rotation_z: S,
    /// The axial force \[N\], tension positive.
    pub axial_force: S,
    /// The shear force `Q = M'` \[N\], with x from the input end to the output end; in space along y of the member.
    pub shear: S,
    /// The bending moment `M = EI Θ'` [N m]; in space about z of the member.
    pub moment: S,
    /// The shear force along z of the member, `Qz = -My'` \[N\].
    pub shear_z: S,
    /// The bending moment about y of the member, `My = EI_y Θy'` [N m].
    pub moment_y: S,
    /// The torque about x of the member, `Mx = GJ Θx'` [N m].
    pub torque: S,
}

impl<Y, S> PlaneStates<'_, Y, S>
where
    Y: PlacedMotions<S>,
    S: Oscillation<Y::Parameter>,
{
    /// The state inside of a member, at a distance \[m\] from its input end: exact, however short its waves are.
    ///
    /// # Errors
    /// [`MotionError::Outside`] for a distance beyond its ends; [`MotionError::NoInside`] for springs, dampers and joints;
    /// [`MotionError::NoSuchPoint`] for a member that this system has not got.
    pub fn along<E>(&self, label: MemberLabel<Y::Model, E>, distance: f64) -> Result<MemberState<S>, MotionError> {
        let parts = self.system.parts_of(label.handle())?;
        let Inside { length, .. } = self.inside(parts.start)?;
        // lengths follow from places, with their rounding
        if !(0.0..=length * (1.0 + LENGTH)).contains(&distance) {
            return Err(MotionError::Outside { distance, length });
        }
        let (mut displaced, mut forces) = ([S::zero(); 6], [[S::zero(); 3]; 3]);
        for part in parts {
            let motion = self.motion_at(part, distance.min(length));
            let own = self.in_global_axes(part, 0, motion.displacements);
            displaced.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            forces[self.system.placement(part).part()] = motion.internal(1);
        }
        let [displacement_x, displacement_y, rotation_z, displacement_z, rotation_x, rotation_y] = displaced;
        let [[axial_force, shear, moment], [_, shear_z, about_minus_y], [.., torque]] = forces;
        Ok(MemberState {
            displacement_x,
            displacement_y,
            displacement_z,
            rotation_x,
            rotation_y,
            rotation_z,
            axial_force,
            shear,
            moment,
            shear_z,
            moment_y: -about_minus_y,
            torque,
        })
    }

    /// The interior of a member.
    pub(super) fn inside(&self, member: usize) -> Result<Inside, MotionError> {
        self.member(member)?;
        self.system.visit_member(member, InsideOf(self.x)).flatten().ok_or(MotionError::NoInside)
    }

    /// The motion of a cross section of a member, in its axes.
    pub(super) fn motion_at(&self, member: usize, distance: f64) -> EndMotion<S> {
        let (motion, load) = (self.member_ends(member), self.load_on(member));
        self.system.visit_member(member, MotionAt { motion, load, distance }).unwrap_or(motion.ends[1])
    }

    /// The size of the largest displacement \[m\], of nodes and inside of members.
    pub(crate) fn largest_deflection(&self) -> f64 {
        let [nodes, members] = self.system.sizes();
        let mut largest = 0.0_f64;
        for node in &self.motion.nodes.as_ref()[..nodes] {
            largest = largest.max(displacements(*node).into_iter().map(square).sum());
        }
        for member in 0..members {
            let placement = self.system.placement(member);
            for motion in &self.motion.members.as_ref()[member] {
                largest = largest.max(square(motion.displacements[0]) + square(motion.displacements[1]));
            }
            let Ok(inside) = self.inside(member) else { continue };
            // the second part of a member follows its first one
            let next = (placement.part() == 0).then_some(member + 1).filter(|next| *next < members);
            let second = next.filter(|next| self.system.placement(*next).part() == 1);
            let at = |distance: f64| {
                let [along, across, _] = self.motion_at(member, distance).displacements;
                let of_second = second.map_or(0.0, |second| square(self.motion_at(second, distance).displacements[1]));
                square(along) + square(across) + of_second
            };
            let width = inside.length / f64::from(inside.samples());
            let places = (1..inside.samples()).map(|sample| f64::from(sample) * width);
            let best = places
                .map(|place| (at(place), place))
                .fold((0.0, 0.0), |best, next| if next.0 > best.0 { next } else { best });
            // beside the largest sample there is one maximum
            largest = largest.max(maximum(at, best.1 - width, best.1 + width));
        }
        Scalar::sqrt(largest)
    }
}

/// The largest value of a function between two places, that rises and then falls.
fn maximum(at: impl Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (mut from, mut to) = (from.max(0.0), to);
    for _ in 0..HALVINGS {
        let third = (to - from) / 3.0;
        if at(from + third) < at(to - third) { from += third } else { to -= third }
    }
    at(0.5 * (from + to))
}

impl<Y, T> PlaneStates<'_, Y, T>
where
    T: Real + Oscillation<T>,
    Y: PlacedMotions<T> + Placed<Parameter = T>,
{
    /// Number of nodes inside of a member: places between its ends where its deflection across changes its sign.
    ///
    /// Shapes of damped systems are complex and have no nodes.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a member that this system has not got; [`MotionError::NoInside`] for springs, dampers and joints.
    pub fn nodes<E>(&self, label: MemberLabel<Y::Model, E>) -> Result<usize, MotionError> {
        let member = self.system.member_of(label.handle())?;
        let inside = self.inside(member)?;
        let samples = inside.samples();
        let width = inside.length / f64::from(samples);
        let at = |sample: u32| self.motion_at(member, width * f64::from(sample)).displacements;
        let sizes = (0..=samples).flat_map(|sample| at(sample).into_iter().take(2)).map(Scalar::size);
        let level = LEVEL * sizes.fold(0.0, f64::max);
        let deflection = |sample: u32| Some(at(sample)[1]).filter(|across| across.size() > level).unwrap_or(T::zero());
        Ok(sign_changes(samples, deflection))
    }
}

/// Square of the modulus.
fn square<T: Real, S: Oscillation<T>>(number: S) -> f64 {
    number.size() * number.size()
}

struct InsideOf<S>(S);

impl<S: Scalar> VisitMember<S> for InsideOf<S> {
    type Output = Option<Inside>;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> Option<Inside> {
        E::inside(built, self.0)
    }
}

struct MotionAt<S> {
    motion: MemberEnds<S>,
    load: Option<[S; 2]>,
    distance: f64,
}

impl<S: Scalar> VisitMember<S> for MotionAt<S> {
    type Output = EndMotion<S>;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> EndMotion<S> {
        match self.load {
            None => E::motion_at(built, &self.motion, self.distance),
            Some(load) => E::motion_under_load(built, &self.motion, load, self.distance),
        }
    }
}

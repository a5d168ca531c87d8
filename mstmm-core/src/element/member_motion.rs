//! How a member of a plane structure moves between its ends, and the energies of its motion.

use crate::element::deflection::Deflection;
use crate::element::energies::Inside;
use crate::element::traits::Element;
use crate::model::{EndMotion, Ends, State};
use crate::number::Scalar;

/// The motion of a member at a frequency: what its ends do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberEnds<S> {
    /// The frequency: ω for a real scalar, λ for a complex one.
    pub x: S,
    /// The motions of the input end and of the output end.
    pub ends: [EndMotion<S>; 2],
}

impl<S: Scalar> MemberEnds<S> {
    /// The states of bending at both ends.
    pub(crate) fn bending(&self) -> Ends<S> {
        let [input, output] = [0, 1].map(|end| self.ends[end].bending(end));
        Ends { x: self.x, input, output }
    }

    /// The states of an element of a translation path at both ends, `[Y, Q]`, with Y along the member: what
    /// [`Energies`](crate::Energies) take.
    pub fn translation(&self) -> Ends<S> {
        let [input, output] = self.along(0);
        let state = |[y, q]: [S; 2]| State { y, q, ..State::default() };
        Ends { x: self.x, input: state(input), output: state(output) }
    }

    /// The states of an element of a rotation path at both ends, `[Θ, M]`.
    pub fn rotation(&self) -> Ends<S> {
        let [input, output] = self.along(2);
        let state = |[theta, force]: [S; 2]| State { theta, m: -force, ..State::default() };
        Ends { x: self.x, input: state(input), output: state(output) }
    }

    /// Displacement and force of a freedom at both ends, where the force is that of what is before the end on what is behind it.
    fn along(&self, freedom: usize) -> [[S; 2]; 2] {
        let [input, output] = self.ends.map(|end| [end.displacements[freedom], end.forces[freedom]]);
        [input, [output[0], -output[1]]]
    }
}

/// The forms of two motions of a member: of mass `∫ m u₁ u₂ dx`, of stiffness `∫ EI y₁'' y₂'' dx + ..`, and of damping `C Δu₁ Δu₂`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Forms<S> {
    /// Twice the kinetic energy of one motion, over `(dt)²`.
    pub mass: S,
    /// Twice the strain energy of one motion.
    pub stiffness: S,
    /// The power that dampers take from one motion, over `(dt)²`.
    pub damping: S,
}

impl<S: Scalar> Forms<S> {
    /// The forms of what has neither mass nor stiffness nor damping.
    pub fn none() -> Self {
        Forms { mass: S::zero(), stiffness: S::zero(), damping: S::zero() }
    }

    /// The forms of two parts.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Forms {
            mass: self.mass + other.mass,
            stiffness: self.stiffness + other.stiffness,
            damping: self.damping + other.damping,
        }
    }
}

/// An element of a plane structure that says how it moves between its ends.
///
/// An element of a path of one motion that has [`Energies`](crate::Energies) hands its ends on to these, by
/// [`MemberEnds::translation`] or [`MemberEnds::rotation`].
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not say how it moves between points with places",
    label = "no `MemberMotion<{S}>` for this element",
    note = "mode shapes, responses and sensitivities of frames need it; an element of your own implements `mstmm::element::MemberMotion<S>` \
            for every `S: mstmm::number::Oscillation<T>`"
)]
pub trait MemberMotion<S: Scalar>: Element {
    /// The forms of two motions.
    fn forms(built: &Self::Built, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S>;

    /// The interior between the ends; `None` for a member without one.
    #[inline]
    fn inside(_built: &Self::Built, _x: S) -> Option<Inside> {
        None
    }

    /// The motion of a cross section at a distance \[m\] from the input end, as that of the output end of the part before it.
    #[inline]
    fn motion_at(_built: &Self::Built, motion: &MemberEnds<S>, _distance: f64) -> EndMotion<S> {
        motion.ends[1]
    }

    /// The deflection across the member, by which loads move along it. A line that moves in one freedom says its displacement in that.
    ///
    /// By default none: no load moves along a member whose motion is no sum of exponentials, as that of a tapered beam.
    #[inline]
    fn deflection(_built: &Self::Built, _motion: &MemberEnds<S>) -> Option<Deflection<S>> {
        None
    }

    /// The work of loads of 1 per length along the member and across it on a motion, `[∫ u dx, ∫ y dx]`; `None` where no such load acts.
    #[inline]
    fn load_work(_built: &Self::Built, _motion: &MemberEnds<S>) -> Option<[S; 2]> {
        None
    }

    /// The mass per length; zero of a member without mass. One that says it and not what loads work has no weight, and the weight of a model
    /// with it is refused.
    #[inline]
    fn mass_per_length(_built: &Self::Built) -> S {
        S::zero()
    }

    /// The motion of a cross section as [`motion_at`](MemberMotion::motion_at), under loads per length along the member and across it.
    #[inline]
    fn motion_under_load(built: &Self::Built, motion: &MemberEnds<S>, _load: [S; 2], distance: f64) -> EndMotion<S> {
        Self::motion_at(built, motion, distance)
    }
}

/// What an answer about motions does with a member, of whatever type.
pub trait VisitMember<S: Scalar> {
    /// What comes of it.
    type Output;

    /// Visits a member.
    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> Self::Output;
}

//! Energies of modes of plane structures: of members, and of rigid bodies.

use crate::answer::energy_shares::EnergyShares;
use crate::answer::network::shape::PlaneShape;
use crate::element::{Forms, MemberEnds, MemberMotion, VisitMember};
use crate::model::{EndMotion, MemberLabel, MotionError, PlanePoint};
use crate::number::Scalar;
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, PlaneFrequency};
use num_traits::Zero;

impl<Y, S> PlaneShape<'_, Y, S>
where
    Y: MovingNetwork<S>,
    S: PlaneFrequency<<Y as System>::Parameter>,
{
    /// The modal stiffness `φᵀ K φ`; at a natural frequency ω² times the modal mass.
    pub fn modal_stiffness(&self) -> S {
        let members = 0..self.system.sizes()[1];
        members.fold(S::zero(), |sum, member| sum + self.forms(member, |number| number).stiffness)
    }

    /// The shares of a member in the energies of this mode, averaged over a cycle.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a member that this system has not got.
    pub fn energy_shares<E>(
        &self,
        label: MemberLabel<Y::Model, E>,
    ) -> Result<EnergyShares<<Y as System>::Parameter>, MotionError> {
        let parts = self.system.parts_of(label.handle())?;
        Ok(self.shares(parts.map(|part| self.forms(part, S::conjugate)).fold(Forms::none(), Forms::plus)))
    }

    /// The shares of the rigid bodies and masses that move with a point; they have kinetic energy alone.
    ///
    /// # Errors
    /// [`MotionError::NoSuchPoint`] for a point that this system has not got.
    pub fn body_shares(
        &self,
        point: PlanePoint<Y::Model>,
    ) -> Result<EnergyShares<<Y as System>::Parameter>, MotionError> {
        let node = self.node_of(point)?;
        Ok(self.shares(Forms { mass: self.mass_form(node), ..Forms::none() }))
    }

    /// Forms of a part beside those of the whole, all of the motion and its conjugate, which are real but for what a loss factor takes.
    fn shares(&self, part: Forms<S>) -> EnergyShares<<Y as System>::Parameter> {
        let whole = self.whole();
        let share = |of: &dyn Fn(&Forms<S>) -> S| {
            let [part, whole] = [of(&part), of(&whole)].map(|form| form.to_complex().re);
            if whole.is_zero() { whole } else { part / whole }
        };
        EnergyShares {
            strain: share(&|forms| forms.stiffness),
            kinetic: share(&|forms| forms.mass),
            dissipated: share(&|forms| self.dissipation(forms)),
        }
    }

    /// The form of damping of the motion and its conjugate, with what a loss factor takes, `Im K/Im λ`.
    fn dissipation(&self, forms: &Forms<S>) -> S {
        if !self.system.frequency_estimates().has_loss() {
            return forms.damping;
        }
        let lost = forms.stiffness.to_complex().im / self.x.to_complex().im;
        forms.damping + S::from_parameter(lost)
    }

    /// What the modal mass of an undamped motion differs from 1 by, as the motions between the ends of members have it. These follow from the ends. Where a
    /// motion is trapped inside a member, its ends are rounding.
    pub(super) fn trapped(&self) -> f64 {
        if !self.x.lambda().is_zero() {
            return 0.0;
        }
        let Forms { mass, damping, .. } = self.whole();
        let slope = self.x.slope_of_lambda_squared();
        let spun = if const { Y::SPINS } && !slope.is_zero() { damping / slope } else { S::zero() };
        (mass + spun - S::one()).size()
    }

    /// The forms of the whole motion and its conjugate.
    pub(super) fn whole(&self) -> Forms<S> {
        let [nodes, members] = self.system.sizes();
        let of_members = (0..members).map(|member| self.forms(member, S::conjugate));
        let mut whole = of_members.fold(Forms::none(), Forms::plus);
        whole.mass = (0..nodes).fold(whole.mass, |sum, node| sum + self.mass_form(node));
        whole
    }

    /// The forms of the motion of a member and a function of it.
    fn forms(&self, member: usize, of: impl Fn(S) -> S) -> Forms<S> {
        let first = self.member_ends(member);
        let ends = first.ends.map(|EndMotion { displacements, forces }| EndMotion {
            displacements: displacements.map(&of),
            forces: forces.map(&of),
        });
        let second = MemberEnds { x: of(first.x), ends };
        self.system.visit_member(member, FormsOf { first, second }).unwrap_or_else(Forms::none)
    }

    /// The mass form of the bodies of a node, of its motion and its conjugate.
    fn mass_form(&self, node: usize) -> S {
        let displacements = self.motion.nodes.as_ref()[node];
        self.system.node(node).0.mass_form(displacements, displacements.map(S::conjugate))
    }
}

struct FormsOf<S> {
    first: MemberEnds<S>,
    second: MemberEnds<S>,
}

impl<S: Scalar> VisitMember<S> for FormsOf<S> {
    type Output = Forms<S>;

    fn member<E: MemberMotion<S>>(self, built: &E::Built) -> Forms<S> {
        E::forms(built, &self.first, &self.second)
    }
}

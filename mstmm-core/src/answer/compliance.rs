//! How far a load at rest moves its own place: of a system, and over a box of tolerances.

use crate::answer::network::own_load::compliance_under;
use crate::answer::questions::ModalAnalysis;
use crate::model::{Load, MotionError, PlaneLoad, SearchError, ToleranceError};
use crate::number::{Oscillation, Real};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, Placed, PlaneFrequency};
use crate::pass::searched::Undamped;
use crate::pass::tree::{ExtendedTree, Planned};
use crate::search::{NaturalFrequencies, ToleranceBox};
use core::ops::RangeInclusive;

/// A system whose compliance under loads `L` is known.
pub trait Compliance<L>: System {
    /// The displacement at the place of a load of 1 at rest and along it, `aᵀ K⁻¹ a` [m/N] or [rad/(N m)]; of a load along a member its work.
    ///
    /// # Errors
    /// [`MotionError::NotModal`] for what is no force, moment or load along a member, as a weight, a dislocation or a motion of a support; [`MotionError::Resonance`] where nothing holds the
    /// place; [`MotionError::NoUniformLoad`] for a load along a path without places; else as a response at rest.
    fn compliance(&self, load: L) -> Result<Self::Parameter, MotionError>;

    /// The load of another system of the same topology at the same place of this one.
    #[doc(hidden)]
    fn at_same_place(&self, load: L) -> L;
}

impl<T, Y> Compliance<PlaneLoad<<Y as Placed>::Model>> for Y
where
    T: Real + PlaneFrequency<T>,
    Y: Placed + MovingNetwork<T> + System<Parameter = T>,
{
    fn compliance(&self, load: PlaneLoad<<Y as Placed>::Model>) -> Result<T, MotionError> {
        compliance_under(self, load)
    }

    fn at_same_place(&self, load: PlaneLoad<<Y as Placed>::Model>) -> PlaneLoad<<Y as Placed>::Model> {
        load.in_frame(self.frame_number())
    }
}

impl<T, Y> Compliance<Load<<Y as Planned>::Model>> for Y
where
    T: Real + Oscillation<T>,
    Y: ExtendedTree<T> + Planned + System<Parameter = T>,
{
    fn compliance(&self, load: Load<<Y as Planned>::Model>) -> Result<T, MotionError> {
        let own = load.dual().ok_or(MotionError::NoUniformLoad)?;
        if own.coordinate.is_force() {
            return Err(MotionError::NotModal);
        }
        self.frequency_response(load, own)?.at(T::zero())
    }

    fn at_same_place(&self, load: Load<<Y as Planned>::Model>) -> Load<<Y as Planned>::Model> {
        load
    }
}

impl<Y: Undamped> ToleranceBox<Y> {
    /// How far a load of 1 at rest moves its own place, from the stiff system to the soft one: in all systems of the box it does so by a value between both. Both are answers, not proofs.
    ///
    /// # Errors
    /// [`ToleranceError::Search`] for a soft system with motions that grow, in which a load at rest has no motion; [`ToleranceError::Motion`] as
    /// [`compliance`](Compliance::compliance).
    pub fn compliance<L: Copy>(&self, load: L) -> Result<RangeInclusive<Y::Parameter>, ToleranceError>
    where
        Y: Compliance<L>,
    {
        let modes = self.soft().unstable_modes()?;
        if modes > 0 {
            return Err(SearchError::Unstable { modes }.into());
        }
        let both = [self.stiff(), self.soft()];
        let [stiff, soft] = both.map(|system| system.compliance(load));
        // points of a frame are no points of another one
        let is_other = [&stiff, &soft].map(|answer| matches!(answer, Err(MotionError::OtherFrame { .. })));
        let of = |end: usize| both[end].compliance(both[end].at_same_place(load));
        let stiff = if is_other == [true, false] { of(0) } else { stiff };
        let soft = if is_other == [false, true] { of(1) } else { soft };
        Ok(stiff?..=soft?)
    }
}

//! A beam between two points of a plane structure: how it moves.

use crate::element::{Forms, Inside, MemberEnds, MemberMotion};
use crate::elements::beam::{Beam, BuiltBeam};
use crate::elements::shared::bending_motion::BendingMotion;
use crate::model::EndMotion;
use crate::number::{Oscillation, Real};

impl<T: Real, S: Oscillation<T>> MemberMotion<S> for Beam<T> {
    fn forms(built: &BuiltBeam<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        built.motion().member_forms(first, second)
    }

    fn inside(built: &BuiltBeam<T>, x: S) -> Option<Inside> {
        Some(built.motion().inside(x))
    }

    fn motion_at(built: &BuiltBeam<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        let state = built.motion().state_at(&motion.bending(), T::from_f64(distance));
        EndMotion::bent(state)
    }
}

impl<T: Real> BendingMotion<T> {
    /// The forms of bending of a member.
    pub(crate) fn member_forms<S: Oscillation<T>>(&self, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let [mass, stiffness] = self.forms(&first.bending(), &second.bending());
        Forms { mass, stiffness, ..Forms::none() }
    }

    /// The length of a beam and its wave number.
    pub(crate) fn inside<S: Oscillation<T>>(&self, x: S) -> Inside {
        let length = self.parameters.length.to_f64();
        Inside { length, wave_number: self.z(x).size() / length }
    }
}

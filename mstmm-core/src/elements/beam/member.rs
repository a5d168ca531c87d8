//! A beam between two points of a plane structure: how it moves.

use crate::element::{Forms, Inside, MemberEnds, MemberMotion};
use crate::elements::beam::{Beam, BuiltBeam};
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

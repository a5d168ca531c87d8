//! A beam between two points of a plane structure: how it moves.

use crate::element::{Deflection, Forms, Inside, MemberEnds, MemberGradient, MemberMotion};
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

    fn deflection(built: &BuiltBeam<T>, motion: &MemberEnds<S>) -> Option<Deflection<S>> {
        Some(built.motion().deflection(&motion.bending()))
    }

    fn load_work(built: &BuiltBeam<T>, motion: &MemberEnds<S>) -> Option<[S; 2]> {
        Some([S::zero(), built.motion().load_work(&motion.bending())])
    }

    fn mass_per_length(built: &BuiltBeam<T>) -> S {
        S::from_parameter(built.parameters.mass_per_length)
    }

    fn motion_under_load(
        built: &BuiltBeam<T>,
        motion: &MemberEnds<S>,
        [_, load]: [S; 2],
        distance: f64,
    ) -> EndMotion<S> {
        EndMotion::bent(built.motion().state_under(&motion.bending(), load, T::from_f64(distance)))
    }
}

impl<T: Real, S: Oscillation<T>> MemberGradient<S> for Beam<T> {
    type Gradient = Beam<S>;

    fn member_gradient(built: &BuiltBeam<T>, motion: &MemberEnds<S>) -> Beam<S> {
        built.motion().gradient(&motion.bending())
    }
}

//! A tapered beam between two points of a line: how it moves, and how its parameters change its work.

use crate::element::{Energies, Forms, Inside, MemberEnds, MemberGradient, MemberMotion};
use crate::elements::tapered_beam::{BuiltTaperedBeam, TaperedBeam};
use crate::model::EndMotion;
use crate::number::{Oscillation, Real};

impl<T: Real, S: Oscillation<T>> MemberMotion<S> for TaperedBeam<T> {
    fn forms(built: &BuiltTaperedBeam<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let (first, second) = (first.bending(), second.bending());
        Forms {
            mass: Self::mass_form(built, &first, &second),
            stiffness: Self::stiffness_form(built, &first, &second),
            ..Forms::none()
        }
    }

    fn inside(built: &BuiltTaperedBeam<T>, x: S) -> Option<Inside> {
        <Self as Energies<S>>::inside(built, x)
    }

    fn motion_at(built: &BuiltTaperedBeam<T>, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        EndMotion::bent(Self::state_at(built, &motion.bending(), distance))
    }

    fn mass_per_length(built: &BuiltTaperedBeam<T>) -> S {
        S::from_parameter(built.parameters.mass_per_length)
    }
}

impl<T: Real, S: Oscillation<T>> MemberGradient<S> for TaperedBeam<T> {
    type Gradient = TaperedBeam<S>;

    fn member_gradient(built: &BuiltTaperedBeam<T>, motion: &MemberEnds<S>) -> TaperedBeam<S> {
        built.gradient(&motion.bending())
    }
}

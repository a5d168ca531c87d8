//! The string between points with places: its chart, and how it moves there.

use crate::Cable;
use mstmm::element::{
    Chart, Charted, EndMotion, Energies, Forms, FrequencyPowers, Inside, MemberEnds, MemberGradient, MemberMotion,
};
use mstmm::number::{Frequency, Oscillation, Parameter, Real, Size};

impl<T: Parameter, S: Frequency<T>> Charted<S> for Cable<T> {
    /// Its length is its own, however far apart the points are.
    fn chart(cable: &Self, at: &FrequencyPowers<S>, _distance: S) -> Chart<S> {
        let (cos, sinc, phi) = cable.waves(at.lambda_squared);
        let flexibility = S::from_parameter(cable.length / cable.tension);
        let transfer = [[cos, -sinc * flexibility], [phi * phi * sinc / flexibility, cos]];
        // held at both ends it vibrates at φ = π, 2π, ..
        let held = (phi.size() / S::Size::of(core::f64::consts::PI)).whole();
        let waves = phi.size().first().max(1.0);
        Chart::translation(transfer, held, waves * (cable.tension / cable.length).to_f64())
    }
}

impl<T: Real, S: Oscillation<T>> MemberMotion<S> for Cable<T> {
    fn forms(cable: &Self, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        let (first, second) = (first.translation(), second.translation());
        let (mass, stiffness) = (Self::mass_form(cable, &first, &second), Self::stiffness_form(cable, &first, &second));
        Forms { mass, stiffness, ..Forms::none() }
    }

    fn inside(cable: &Self, x: S) -> Option<Inside> {
        <Self as Energies<S>>::inside(cable, x)
    }

    fn motion_at(cable: &Self, motion: &MemberEnds<S>, distance: f64) -> EndMotion<S> {
        EndMotion::translated(Self::state_at(cable, &motion.translation(), distance))
    }

    /// What a load along it works is not said, so that a weight is refused.
    fn mass_per_length(cable: &Self) -> S {
        S::from_parameter(cable.mass_per_length)
    }
}

impl<T: Real, S: Oscillation<T>> MemberGradient<S> for Cable<T> {
    type Gradient = Cable<S>;

    fn member_gradient(cable: &Self, motion: &MemberEnds<S>) -> Cable<S> {
        Self::gradient(cable, &motion.translation())
    }
}

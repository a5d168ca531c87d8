//! The gyroscopic moment of a disc, between its point and the ground.

use crate::element::{
    ByName, Charted, Element, Forms, MemberEnds, MemberGradient, MemberMotion, MemberNumbers, Spins, TransferMatrix,
};
use crate::elements::shared::massless::off_pole;
use crate::elements::shared::spin::Spin;
use crate::model::{EndMotion, FrequencyEstimates, InvalidParameter, Rotation};
use crate::number::{Frequency, FrequencyPowers, Oscillation, Parameter, Real, Scalar, Single, Size, binary_exponent};
use crate::structure::{Chart, Units, unit_of};
use mstmm_plan::Freedoms;
use nalgebra::Matrix2;

/// The gyroscopic moment of a [`Disc`](crate::elements::Disc) at the ω of a whirl: `M = I_p Ω ω (Θ_O - Θ_I)`. Its point bears the mass and the inertia of the disc. The
/// other end rests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gyroscope<T> {
    /// Polar moment of inertia I_p about the axis [kg m²], zero or positive.
    pub polar_inertia: T,
    /// Speed Ω [rad/s] about the axis, of either sign.
    pub speed: T,
}

/// The index of the rotation among the freedoms of an end.
const ROTATION: usize = 2;

/// How far the output end turns beyond the input end.
fn turned<S: Scalar>([input, output]: &[EndMotion<S>; 2]) -> S {
    output.displacements[ROTATION] - input.displacements[ROTATION]
}

#[diagnostic::do_not_recommend]
impl<T: Parameter> Element for Gyroscope<T> {
    type State = Rotation;
    type Built = Spin<T>;

    fn build(self) -> Result<Spin<T>, InvalidParameter> {
        let spin = Spin::new(self.polar_inertia, self.speed);
        spin.check("polar_inertia")?;
        Ok(spin)
    }

    fn estimate(built: &Spin<T>, estimates: &mut FrequencyEstimates) {
        built.estimate(estimates, 1.0);
    }

    fn member_numbers(built: &Spin<T>) -> MemberNumbers {
        MemberNumbers::Gyroscope(built.numbers())
    }
}

impl<T: Parameter> Spins for Gyroscope<T> {
    fn turned_round(built: Spin<T>) -> Spin<T> {
        built.turned_round()
    }
}

#[diagnostic::do_not_recommend]
impl<T: Parameter, S: Frequency<T> + Single> TransferMatrix<S> for Gyroscope<T> {
    fn transfer_matrix(built: &Spin<T>, x: S) -> Matrix2<S> {
        let (_, compliance) = off_pole(built.momentum::<S>() * x.signed_omega());
        Matrix2::new(S::one(), compliance, S::zero(), S::one())
    }

    fn denominator(built: &Spin<T>, x: S) -> Option<S> {
        Some(off_pole(built.momentum::<S>() * x.signed_omega()).0)
    }
}

#[diagnostic::do_not_recommend]
impl<T: Parameter, S: Frequency<T>> Charted<S> for Gyroscope<T> {
    /// Over displacements: the moment has either sign, and vanishes at rest.
    fn chart(built: &Spin<T>, at: &FrequencyPowers<S>, _length: S) -> Chart<S> {
        let moment = built.momentum::<S>() * at.x.signed_omega();
        let size = moment.size().first();
        let unit = if size > 0.0 { unit_of(binary_exponent(size)) } else { Units::FINEST.rotation };
        let mut chart = Chart::empty(Freedoms::RZ, Units { displacement: unit, rotation: unit });
        let entry = moment.times_power_of_two(2 * chart.units.of(true));
        chart.set(0, 0, entry);
        chart.set(1, 0, -entry);
        chart.set(1, 1, entry);
        chart
    }
}

#[diagnostic::do_not_recommend]
impl<T: Real, S: Oscillation<T>> MemberMotion<S> for Gyroscope<T> {
    fn forms(built: &Spin<T>, first: &MemberEnds<S>, second: &MemberEnds<S>) -> Forms<S> {
        Forms { damping: built.form(turned(&first.ends) * turned(&second.ends)), ..Forms::none() }
    }
}

#[diagnostic::do_not_recommend]
impl<T: Real, S: Oscillation<T>> MemberGradient<S> for Gyroscope<T> {
    type Gradient = Gyroscope<S>;

    fn member_gradient(built: &Spin<T>, motion: &MemberEnds<S>) -> Gyroscope<S> {
        let angle = turned(&motion.ends);
        let [polar_inertia, speed] = built.gradient(motion.x, angle * angle);
        Gyroscope { polar_inertia, speed }
    }
}

impl<S: Copy> ByName<S> for Gyroscope<S> {
    fn by_name(&self, name: &str) -> Option<S> {
        match name {
            "polar_inertia" => Some(self.polar_inertia),
            "speed" => Some(self.speed),
            _ => None,
        }
    }
}

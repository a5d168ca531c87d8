//! Motions under a uniform load: one of many for each element, from which the work of the load on any other motion follows.
//!
//! With `Q' = h Y + q` beside `Q₁' = h Y₁` of a motion without load the form `Y₁ Q - Q₁ Y - Θ₁ M + M₁ Θ` has the derivative `q Y₁`, whatever the
//! motion under the load is at the ends. Where all waves are short that is the constant `Y = -q/h`, and else one that starts from rest, which
//! is entire in h.

use crate::elements::shared::bending_motion::BendingMotion;
use crate::elements::shared::krylov::krylov;
use crate::elements::shared::rod_motion::{RodMotion, Stretch};
use crate::model::{Ends, State};
use crate::number::{Oscillation, Real, Scalar, series};

/// The work of a load of 1 per length on a motion, given two states of a motion under that load: `∫ Y dx`.
pub(crate) fn work<S: Scalar>(ends: &Ends<S>, [input, output]: [State<S>; 2]) -> S {
    let form = |own: &State<S>, loaded: &State<S>| {
        own.y * loaded.q - own.q * loaded.y - own.theta * loaded.m + own.m * loaded.theta
    };
    form(&ends.output, &output) - form(&ends.input, &input)
}

impl<T: Real> BendingMotion<T> {
    /// The state of a motion under a load of 1 per length, at a distance from the input end.
    pub(crate) fn under_load<S: Oscillation<T>>(&self, x: S, distance: T) -> State<S> {
        let inertia = x.lambda_squared() * self.parameters.mass_per_length;
        if self.z(x).size() > 1.0 {
            return State { y: S::one() / inertia, ..State::default() };
        }
        let flexibility = T::one() / self.parameters.bending_stiffness;
        let square = distance * distance;
        let fourth = -inertia * (square * square * flexibility);
        let ([_, t, u, v], w) = (krylov(fourth), series(fourth, 4, 4));
        State {
            y: w * (square * square * flexibility),
            theta: v * (square * distance * flexibility),
            m: u * square,
            q: t * distance,
        }
    }

    /// The work of a load of 1 per length on a motion.
    pub(crate) fn load_work<S: Oscillation<T>>(&self, ends: &Ends<S>) -> S {
        work(ends, [T::zero(), self.parameters.length].map(|distance| self.under_load(ends.x, distance)))
    }
}

impl<T: Real> RodMotion<T> {
    /// Displacement and axial force of a motion under a load of 1 per length along it, at a distance from the input end.
    pub(crate) fn under_load<S: Oscillation<T>>(&self, x: S, distance: T) -> [S; 2] {
        if self.zeta(x) > 1.0 {
            return [S::one() / self.density(x), S::zero()];
        }
        let square = -self.zeta_squared(x, distance);
        [-series(square, 2, 2) * (distance * distance / self.axial_stiffness), -series(square, 1, 2) * distance]
    }

    /// The work of a load of 1 per length on a motion.
    pub(crate) fn load_work<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        let [input, output] = [T::zero(), self.length].map(|distance| self.under_load(motion.x, distance));
        let form = |[own, own_force]: [S; 2], [loaded, force]: [S; 2]| own_force * loaded - own * force;
        form(motion.ends[1], output) - form(motion.ends[0], input)
    }
}

//! Motions under a uniform load: one of many for each element, from which the work of the load on any other motion follows.
//!
//! With `Q' = h Y + q` beside `Q₁' = h Y₁` of a motion without load the form `Y₁ Q - Q₁ Y - Θ₁ M + M₁ Θ` has the derivative `q Y₁`, whatever the
//! motion under the load is at the ends. Where all waves are short that is the constant `Y = -q/h`, and else one that starts from rest, which
//! is entire in h.

use crate::elements::shared::bending_motion::BendingMotion;
use crate::elements::shared::krylov::krylov;
use crate::elements::shared::rod_motion::Stretch;
use crate::elements::shared::uniform_line::LineSection;
use crate::model::{Ends, State};
use crate::number::{Oscillation, Real, Scalar, series};

/// The work of a load of 1 per length on a motion, given two states of a motion under that load: `∫ Y dx`.
pub(crate) fn work<S: Scalar>(ends: &Ends<S>, [input, output]: [State<S>; 2]) -> S {
    let form = |own: &State<S>, loaded: &State<S>| {
        own.y * loaded.q - own.q * loaded.y - own.theta * loaded.m + own.m * loaded.theta
    };
    form(&ends.output, &output) - form(&ends.input, &input)
}

/// A state under so many times a load of 1 per length, given those at both ends: that of a motion without load beside one under the load,
/// whose states are given at the ends and at the place itself.
pub(crate) fn superposed<S: Scalar>(
    ends: &Ends<S>,
    load: S,
    [input, output, own]: [State<S>; 3],
    without_load: impl Fn(&Ends<S>) -> State<S>,
) -> State<S> {
    let rest = Ends { x: ends.x, input: ends.input.plus(input, -load), output: ends.output.plus(output, -load) };
    without_load(&rest).plus(own, load)
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

    /// The state at a distance from the input end under so many times that load.
    pub(crate) fn state_under<S: Oscillation<T>>(&self, ends: &Ends<S>, load: S, distance: T) -> State<S> {
        let under = [T::zero(), self.parameters.length, distance].map(|distance| self.under_load(ends.x, distance));
        superposed(ends, load, under, |rest| self.state_at(rest, distance))
    }
}

impl<T: Real> LineSection<T> {
    /// Displacement and axial force of a motion under a load of 1 per length along it, at a distance from the input end, given `mλ² + k`.
    fn under_load<S: Oscillation<T>>(&self, density: S, distance: T) -> [S; 2] {
        if self.zeta_of(density) > 1.0 {
            return [S::one() / density, S::zero()];
        }
        let square = -self.zeta_squared(density, distance);
        [-series(square, 2, 2) * (distance * distance / self.stiffness), -series(square, 1, 2) * distance]
    }

    /// The work of a load of 1 per length on a motion, given `mλ² + k` and displacement and force at both ends.
    pub(crate) fn load_work<S: Oscillation<T>>(&self, density: S, ends: &[[S; 2]; 2]) -> S {
        let [input, output] = [T::zero(), self.length].map(|distance| self.under_load(density, distance));
        let form = |[own, own_force]: [S; 2], [loaded, force]: [S; 2]| own_force * loaded - own * force;
        form(ends[1], output) - form(ends[0], input)
    }

    /// Displacement and axial force at a distance from the input end under so many times that load.
    pub(crate) fn at_under<S: Oscillation<T>>(&self, density: S, ends: &[[S; 2]; 2], load: S, distance: T) -> [S; 2] {
        let under = [T::zero(), self.length, distance].map(|distance| self.under_load(density, distance));
        let plus = |one: [S; 2], other: [S; 2], factor: S| [one[0] + other[0] * factor, one[1] + other[1] * factor];
        let rest = [0, 1].map(|end| plus(ends[end], under[end], -load));
        plus(self.inside_of(density, &rest, distance), under[2], load)
    }

    /// As [`load_work`](LineSection::load_work), without damping.
    pub(crate) fn undamped_load_work<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        self.load_work(self.density(motion.x), &motion.ends)
    }

    /// As [`at_under`](LineSection::at_under), without damping.
    pub(crate) fn undamped_at_under<S: Oscillation<T>>(&self, motion: &Stretch<S>, load: S, distance: T) -> [S; 2] {
        self.at_under(self.density(motion.x), &motion.ends, load, distance)
    }
}

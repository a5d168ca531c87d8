//! Motions of a member that stretches, or of a line: displacement and force between its ends, and the forms of mass and stiffness of two motions.

use crate::element::{Deflection, Inside, MemberEnds};
use crate::elements::shared::bending_motion::{APART, LONG};
use crate::elements::shared::krylov::cosine_and_sinc;
use crate::elements::shared::line_forms::{half, smaller_sum};
use crate::elements::shared::uniform_line::LineSection;
use crate::model::{Ends, State};
use crate::number::gauss::integrals;
use crate::number::{Oscillation, Real, Scalar, exponential};
use num_complex::Complex;
use num_traits::Zero;

/// A longitudinal motion: the frequency, and the displacement and the axial force at both ends, tension positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch<S> {
    pub(crate) x: S,
    pub(crate) ends: [[S; 2]; 2],
}

impl<S: Scalar> Stretch<S> {
    /// The longitudinal motion of a member.
    pub(crate) fn of(motion: &MemberEnds<S>) -> Self {
        Stretch::in_freedom(motion, 0)
    }

    /// The motion of a translation path, where Q is the opposite of the force in the line, or of a rotation path.
    pub(crate) fn of_path(ends: &Ends<S>, is_rotation: bool) -> Self {
        let of = |state: State<S>| if is_rotation { [state.theta, state.m] } else { [state.y, -state.q] };
        Stretch { x: ends.x, ends: [of(ends.input), of(ends.output)] }
    }

    /// The motion of a member in a freedom that couples with no other.
    pub(crate) fn in_freedom(motion: &MemberEnds<S>, freedom: usize) -> Self {
        let ends = [0, 1].map(|end| [motion.ends[end].displacements[freedom], motion.ends[end].internal(end)[freedom]]);
        Stretch { x: motion.x, ends }
    }
}

/// The state of a path with a displacement and the force in a line.
pub(crate) fn path_state<S: Scalar>([displacement, force]: [S; 2], is_rotation: bool) -> State<S> {
    if is_rotation {
        return State { theta: displacement, m: force, ..State::default() };
    }
    State { y: displacement, q: -force, ..State::default() }
}

/// Motions `H u'' = (m λ² + k) u`: of rods, and those of strings and of shafts, which are the same in other letters.
impl<T: Real> LineSection<T> {
    /// The dynamic stiffness of a unit of length, `m λ² + k`.
    pub(crate) fn density<S: Oscillation<T>>(&self, x: S) -> S {
        x.lambda_squared() * self.inertia + S::from_parameter(self.foundation)
    }

    /// The square of the wave number times a length, `ζ² = -(mλ² + k)l²/EA`, given `mλ² + k`.
    pub(crate) fn zeta_squared<S: Oscillation<T>>(&self, density: S, length: T) -> S {
        -density * (length * length / self.stiffness)
    }

    /// The displacement along a line: `y'' = κ y`.
    pub(crate) fn deflection<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> Deflection<S> {
        let square = -self.zeta_squared(self.density(motion.x), self.length);
        let derivatives = |[y, force]: [S; 2]| {
            let slope = force * (self.length / self.stiffness);
            [y, slope, square * y, square * slope]
        };
        Deflection { sum: square, product: S::zero(), square: square * square, ends: motion.ends.map(derivatives) }
    }

    /// The wave number times the length.
    pub(crate) fn zeta<S: Oscillation<T>>(&self, x: S) -> f64 {
        self.zeta_of(self.density(x))
    }

    /// The wave number times the length, given `mλ² + k`.
    pub(crate) fn zeta_of<S: Oscillation<T>>(&self, density: S) -> f64 {
        self.zeta_squared(density, self.length).size().sqrt()
    }

    /// The length of the member and its wave number.
    pub(crate) fn inside<S: Oscillation<T>>(&self, x: S) -> Inside {
        let length = self.length.to_f64();
        Inside { length, wave_number: self.zeta(x) / length }
    }

    /// Displacement and axial force at a distance from the input end.
    ///
    /// In a short member they follow from those at the input end. In a long one each of the two waves `e^{±sx}` is taken from the end from
    /// which it decays, so that no digits are lost at any frequency.
    pub(crate) fn at<S: Oscillation<T>>(&self, motion: &Stretch<S>, distance: T) -> [S; 2] {
        self.inside_of(self.density(motion.x), &motion.ends, distance)
    }

    /// Displacement and axial force at a distance, given `mλ² + k` and those at both ends.
    pub(crate) fn inside_of<S: Oscillation<T>>(&self, density: S, ends: &[[S; 2]; 2], distance: T) -> [S; 2] {
        if self.zeta_of(density) > 1.0 {
            return self.of_waves(density, ends, distance);
        }
        let (cosine, sinc) = cosine_and_sinc(self.zeta_squared(density, distance));
        let [displacement, force] = ends[0];
        let inertia = density * distance;
        [
            cosine * displacement + sinc * force * (distance / self.stiffness),
            cosine * force + sinc * inertia * displacement,
        ]
    }

    fn of_waves<S: Oscillation<T>>(&self, density: S, ends: &[[S; 2]; 2], distance: T) -> [S; 2] {
        let rate = Scalar::sqrt(density.to_complex() * (T::one() / self.stiffness));
        let mut sum = [Complex::zero(); 2];
        for rate in [rate, -rate] {
            let impedance = rate * self.stiffness;
            let (end, from) = if rate.re <= T::zero() { (0, distance) } else { (1, distance - self.length) };
            let [displacement, force] = ends[end].map(S::to_complex);
            let wave = (displacement + force / impedance) * exponential(rate * from) * T::from_f64(0.5);
            sum = [sum[0] + wave, sum[1] + wave * impedance];
        }
        sum.map(S::from_complex)
    }

    /// Mass and stiffness form of two motions: `[∫ m u₁ u₂ dx, ∫ N₁ N₂/H + k u₁ u₂ dx]`.
    pub(crate) fn forms<S: Oscillation<T>>(&self, first: &Stretch<S>, second: &Stretch<S>) -> [S; 2] {
        let [square, strain] = self.squares(first, second);
        [square * self.inertia, strain + square * self.foundation]
    }

    /// `[∫ u₁ u₂ dx, ∫ N₁ N₂/H dx]`.
    ///
    /// In a long member the second is `[N₁ u₂] - (mλ₁² + k) ∫ u₁ u₂ dx`. The first is a difference of the ends, too, if the frequencies are
    /// apart; that of one motion with itself follows from `N²/H - (mλ² + k) u²`, which is constant along the member.
    fn squares<S: Oscillation<T>>(&self, first: &Stretch<S>, second: &Stretch<S>) -> [S; 2] {
        let (a, b) = (self.density(first.x), self.density(second.x));
        let size = S::size(a).max(S::size(b));
        let waves = self.zeta(first.x).max(self.zeta(second.x));
        let is_long = waves * waves > LONG;
        let between = |of: &dyn Fn(usize) -> S| of(1) - of(0);
        let square = if is_long && S::size(a - b) > APART * size {
            let mixed = |end: usize| {
                let ([u, n], [v, q]) = (first.ends[end], second.ends[end]);
                n * v - u * q
            };
            between(&mixed) / (a - b)
        } else if is_long && first == second {
            let work = between(&|end| first.ends[end][0] * first.ends[end][1]);
            half(work - self.flow(first) * self.length) / a
        } else {
            let [displacement, force] = integrals(self.length, waves, |distance| {
                let ([u, n], [v, q]) = (self.at(first, distance), self.at(second, distance));
                [u * v, n * q]
            });
            return [displacement, force * (T::one() / self.stiffness)];
        };
        [square, between(&|end| first.ends[end][1] * second.ends[end][0]) - a * square]
    }

    /// The derivatives of the dynamic work with respect to length, stiffness, mass and foundation, with the displacements at both ends held.
    pub(crate) fn gradient<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> [S; 4] {
        let [square, strain] = self.squares(motion, motion).map(half);
        let stiffness = strain * (T::one() / self.stiffness);
        [-half(self.flow(motion)), stiffness, motion.x.lambda_squared() * square, square]
    }

    /// `N²/H - (mλ² + k) u²` at the end where its terms are smaller, since they cancel where waves decay.
    fn flow<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        let inertia = self.density(motion.x);
        smaller_sum(motion.ends.map(|[u, n]| [n * n * (T::one() / self.stiffness), -(inertia * u * u)]))
    }
}

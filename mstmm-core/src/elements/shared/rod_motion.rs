//! Motions of a member that stretches, or of a line: displacement and force between its ends, and the forms of mass and stiffness of two motions.

use crate::element::{Inside, MemberEnds};
use crate::elements::shared::bending_motion::{APART, LONG};
use crate::elements::shared::gauss::integrals;
use crate::elements::shared::krylov::cosine_and_sinc;
use crate::elements::shared::line_forms::half;
use crate::number::{Oscillation, Real, Scalar, exponential};
use num_complex::Complex;
use num_traits::Zero;

/// What longitudinal motions of a uniform member need of it: `EA u'' = (m λ² + k) u`. Those of strings and of shafts are the same in other
/// letters.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RodMotion<T> {
    pub(crate) length: T,
    pub(crate) axial_stiffness: T,
    pub(crate) mass_per_length: T,
    pub(crate) foundation_stiffness: T,
}

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

    /// The motion of a member in a freedom that couples with no other.
    pub(crate) fn in_freedom(motion: &MemberEnds<S>, freedom: usize) -> Self {
        let ends = [0, 1].map(|end| [motion.ends[end].displacements[freedom], motion.ends[end].internal(end)[freedom]]);
        Stretch { x: motion.x, ends }
    }
}

impl<T: Real> RodMotion<T> {
    /// The dynamic stiffness of a unit of length, `m λ² + k`.
    pub(crate) fn density<S: Oscillation<T>>(&self, x: S) -> S {
        x.lambda_squared() * self.mass_per_length + S::from_parameter(self.foundation_stiffness)
    }

    /// The square of the wave number times a length, `ζ² = -(mλ² + k)l²/EA`.
    pub(crate) fn zeta_squared<S: Oscillation<T>>(&self, x: S, length: T) -> S {
        -self.density(x) * (length * length / self.axial_stiffness)
    }

    /// The wave number times the length.
    pub(crate) fn zeta<S: Oscillation<T>>(&self, x: S) -> f64 {
        self.zeta_squared(x, self.length).size().sqrt()
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
        if self.zeta(motion.x) > 1.0 {
            return self.of_waves(motion, distance);
        }
        let (cosine, sinc) = cosine_and_sinc(self.zeta_squared(motion.x, distance));
        let [displacement, force] = motion.ends[0];
        let inertia = self.density(motion.x) * distance;
        [
            cosine * displacement + sinc * force * (distance / self.axial_stiffness),
            cosine * force + sinc * inertia * displacement,
        ]
    }

    fn of_waves<S: Oscillation<T>>(&self, motion: &Stretch<S>, distance: T) -> [S; 2] {
        let rate = Scalar::sqrt(self.density(motion.x).to_complex() * (T::one() / self.axial_stiffness));
        let mut sum = [Complex::zero(); 2];
        for rate in [rate, -rate] {
            let impedance = rate * self.axial_stiffness;
            let (end, from) = if rate.re <= T::zero() { (0, distance) } else { (1, distance - self.length) };
            let [displacement, force] = motion.ends[end].map(S::to_complex);
            let wave = (displacement + force / impedance) * exponential(rate * from) * T::from_f64(0.5);
            sum = [sum[0] + wave, sum[1] + wave * impedance];
        }
        sum.map(S::from_complex)
    }

    /// Mass and stiffness form of two motions: `[∫ m u₁ u₂ dx, ∫ N₁ N₂/EA + k u₁ u₂ dx]`.
    pub(crate) fn forms<S: Oscillation<T>>(&self, first: &Stretch<S>, second: &Stretch<S>) -> [S; 2] {
        let [square, strain] = self.squares(first, second);
        [square * self.mass_per_length, strain + square * self.foundation_stiffness]
    }

    /// `[∫ u₁ u₂ dx, ∫ N₁ N₂/EA dx]`.
    ///
    /// In a long member the second is `[N₁ u₂] - (mλ₁² + k) ∫ u₁ u₂ dx`. The first is a difference of the ends, too, if the frequencies are
    /// apart; that of one motion with itself follows from `N²/EA - (mλ² + k) u²`, which is constant along the member.
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
            return [displacement, force * (T::one() / self.axial_stiffness)];
        };
        [square, between(&|end| first.ends[end][1] * second.ends[end][0]) - a * square]
    }

    /// The derivatives of the dynamic work with respect to length, stiffness, mass and foundation, with the displacements at both ends held.
    pub(crate) fn gradient<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> [S; 4] {
        let [square, strain] = self.squares(motion, motion).map(half);
        let stiffness = strain * (T::one() / self.axial_stiffness);
        [-half(self.flow(motion)), stiffness, motion.x.lambda_squared() * square, square]
    }

    /// `N²/EA - (mλ² + k) u²` at the end where its terms are smaller, since they cancel where waves decay.
    fn flow<S: Oscillation<T>>(&self, motion: &Stretch<S>) -> S {
        let inertia = self.density(motion.x);
        let parts = motion.ends.map(|[u, n]| [n * n * (T::one() / self.axial_stiffness), inertia * u * u]);
        let [input, output] = parts.map(|[strain, kinetic]| (strain.size() + kinetic.size(), strain - kinetic));
        if input.0 < output.0 { input.1 } else { output.1 }
    }
}

//! Massless springs and dampers in parallel, and their dynamic stiffness.

use crate::element::{Forms, MemberEnds};
use crate::model::EndMotion;
use crate::number::{Frequency, Oscillation, Parameter, Real, Scalar, Single, Size, Truth, binary_exponent};

/// A spring and a damper in parallel, or one of them.
pub(crate) struct Massless<T> {
    /// Stiffness K.
    pub(crate) stiffness: Option<T>,
    /// Damping C.
    pub(crate) damping: Option<T>,
}

impl<T: Parameter> Massless<T> {
    /// The dynamic stiffness `κ = K + Cλ`.
    #[inline(always)]
    pub(crate) fn dynamic_stiffness<S: Frequency<T>>(&self, x: S) -> S {
        match (self.stiffness, self.damping) {
            (Some(stiffness), Some(damping)) => S::from_parameter(stiffness) + x * damping,
            (Some(stiffness), None) => S::from_parameter(stiffness),
            (None, Some(damping)) => x * damping,
            (None, None) => S::zero(),
        }
    }

    /// `1/κ`.
    #[inline(always)]
    pub(crate) fn compliance<S: Frequency<T> + Single>(&self, x: S) -> S {
        match (self.stiffness, self.damping) {
            (Some(stiffness), None) if !stiffness.vanishes().all() => S::from_parameter(T::one() / stiffness),
            _ => off_pole(self.dynamic_stiffness(x)).1,
        }
    }

    /// κ, whose zero is a pole of the transfer matrix; a spring with a stiffness has none.
    #[inline(always)]
    pub(crate) fn denominator<S: Frequency<T> + Single>(&self, x: S) -> Option<S> {
        let has_pole = self.damping.is_some() || self.stiffness.is_some_and(|stiffness| stiffness.vanishes().all());
        has_pole.then(|| off_pole(self.dynamic_stiffness(x)).0)
    }

    /// The sum of the sizes of K and Cλ: for an overdamped motion κ itself cancels.
    #[inline]
    pub(crate) fn size(&self, lambda: f64) -> f64 {
        self.stiffness.map_or(0.0, T::to_f64) + self.damping.map_or(0.0, |damping| damping.to_f64() * lambda)
    }
}

impl<T: Real> Massless<T> {
    /// The elongation of a member in a freedom.
    pub(crate) fn elongation<S: Frequency<T>>(&self, x: S, ends: &[EndMotion<S>; 2], freedom: usize) -> S {
        let lambda = Scalar::sqrt(x.lambda_squared().size().first());
        elongation(self.dynamic_stiffness(x), self.size(lambda), ends, freedom)
    }

    /// The forms of two motions of a member in a freedom.
    pub(crate) fn member_forms<S: Oscillation<T>>(
        &self,
        freedom: usize,
        first: &MemberEnds<S>,
        second: &MemberEnds<S>,
    ) -> Forms<S> {
        let [one, other] = [first, second].map(|motion| self.elongation(motion.x, &motion.ends, freedom));
        let times = |part: Option<T>| part.map_or(S::zero(), |part| one * other * part);
        Forms { mass: S::zero(), stiffness: times(self.stiffness), damping: times(self.damping) }
    }
}

/// The elongation of a member in a freedom, given its dynamic stiffness κ and the size of the terms of that: a force says how long a stiff
/// spring is, where the difference of displacements is rounding, but for an overdamped motion, whose κ cancels.
pub(crate) fn elongation<S: Scalar>(kappa: S, size: f64, ends: &[EndMotion<S>; 2], freedom: usize) -> S {
    let [input, output] = ends;
    if kappa.size().first() > 0.5 * size {
        return output.forces[freedom] / kappa;
    }
    output.displacements[freedom] - input.displacements[freedom]
}

/// A dynamic stiffness κ and its reciprocal, for κ of any size. Where the reciprocal is not finite, at the pole of the
/// transfer matrix or for a damper without damping, κ is `2^-100`, which is zero in effect once the determinant is multiplied by
/// the denominator.
#[inline]
pub(crate) fn off_pole<S: Single>(kappa: S) -> (S, S) {
    // a complex division alone squares the modulus, which vanishes at half the range
    let shift = -binary_exponent(kappa.size());
    let reciprocal = (S::one() / kappa.times_power_of_two(shift)).times_power_of_two(shift);
    if reciprocal.size().is_finite() || !kappa.size().is_finite() {
        return (kappa, reciprocal);
    }
    let power = |exponent| S::one().times_power_of_two(exponent);
    (power(-100), power(100))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::assert_close;
    use num_complex::Complex;

    #[test]
    fn a_stiffness_of_any_size_has_a_finite_reciprocal() {
        for size in [1e-307, 1e-170, 1e-100, 1.0, 1e100, 1e200] {
            let kappa = Complex::new(size, size);
            let (same, reciprocal) = off_pole(kappa);
            assert_eq!(same, kappa);
            assert_close((reciprocal * size - Complex::new(0.5, -0.5)).norm(), 0.0, 1.0, 4.0);
        }
        for size in [0.0, 5e-324, 1e-320] {
            let (kappa, reciprocal) = off_pole(Complex::new(size, -size));
            assert_eq!(kappa * reciprocal, Complex::ONE);
        }
        assert!(off_pole(Complex::new(f64::NAN, 0.0)).0.is_nan());
    }
}

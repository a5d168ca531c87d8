//! The growth of Δ far from its roots. Without it steps along a contour may grow with the distance.

use crate::number::{Real, Scalar, Scaled};
use crate::search::damped::point::Point;
use crate::search::damped::rectangle::{Rectangle, Side};
use num_complex::Complex;

/// The growth `e^g` of Δ on one side of the imaginary axis, `g = (1 ∓ i) Σz` with `z = βl` of all beams: there one of the
/// exponentials in `ch z cos z` exceeds all others. It has no zero, and its argument is known along every contour.
///
/// Near the axis, and in systems without beams, nothing is divided out.
#[derive(Clone, Copy, Debug)]
pub(super) struct Growth<T> {
    /// `(1 ∓ i) Σ z/sqrt(ω)`.
    factor: Complex<T>,
}

impl<T: Real> Growth<T> {
    /// No growth, `g = 0`.
    pub(super) fn none() -> Self {
        Growth { factor: Complex::from(T::zero()) }
    }

    /// The growth in a rectangle far from the imaginary axis, given the sum of `z/sqrt(ω)`; none in other rectangles.
    pub(super) fn far_from_axis(rectangle: &Rectangle<T>, waves: T) -> Self {
        match rectangle.far_side() {
            Some(Side::Left) => Growth { factor: Complex::new(waves, -waves) },
            Some(Side::Right) => Growth { factor: Complex::new(waves, waves) },
            None => Growth::none(),
        }
    }

    fn is_none(&self) -> bool {
        self.factor.re.is_zero()
    }

    /// `g` and its derivative; below the real axis the conjugates of those at the mirror image.
    fn at(&self, lambda: Complex<T>) -> (Complex<T>, Complex<T>) {
        if lambda.im < T::zero() {
            let (g, slope) = self.at(lambda.conj());
            return (g.conj(), slope.conj());
        }
        let g = self.factor * Scalar::sqrt(Complex::new(lambda.im, -lambda.re));
        (g, g / (lambda + lambda))
    }

    /// Δ and its logarithmic derivative without the growth.
    pub(super) fn taken_from(&self, point: &Point<T>) -> Point<T> {
        if self.is_none() || (point.lambda.re.is_zero() && point.lambda.im.is_zero()) {
            return *point;
        }
        let (g, slope) = self.at(point.lambda);
        let doublings = (g.re.to_f64() * core::f64::consts::LOG2_E) as i64;
        let rest = g.re - T::from_f64(doublings as f64) * T::from_f64(core::f64::consts::LN_2);
        let (sin, cos) = g.im.sin_cos();
        let inverse = Scaled::new(Complex::new(cos, -sin) * (-rest).exp(), -doublings);
        Point { value: point.value.product(inverse), rate: point.rate - slope, ..*point }
    }

    /// Change of the argument of the growth along a polygon.
    pub(super) fn turning(&self, mut polygon: impl Iterator<Item = Complex<T>>) -> f64 {
        let Some(first) = polygon.next().filter(|_| !self.is_none()) else { return 0.0 };
        let last = polygon.last().unwrap_or(first);
        (self.at(last).0.im - self.at(first).0.im).to_f64()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::{argument, assert_close};

    /// Closed form: `ch z cos z` far on the left and on the right, where dividing the growth out leaves a quarter.
    #[test]
    fn what_is_left_of_a_beam_far_from_the_imaginary_axis_is_a_constant() {
        for (re, im) in [(-3e3, 20.0), (-900.0, 0.0), (2e3, 15.0), (-3e3, -20.0)] {
            let (left, right) = if re < 0.0 { (-4e3, -500.0) } else { (500.0, 4e3) };
            let growth = Growth::far_from_axis(&Rectangle { left, right, low: -30.0, high: 30.0 }, 1.0);
            let lambda: Complex<f64> = Complex::new(re, im);
            let z = Complex::new(lambda.im, -lambda.re).sqrt();
            let value = Scaled::new(z.cosh() * z.cos(), 0);
            let rate = z.tanh() - z.tan();
            let rate = rate * z / (lambda + lambda);
            let left = growth.taken_from(&Point { lambda, value, rate, is_root: false });
            assert_close((left.value.value() - Complex::from(0.25)).norm(), 0.0, 1.0, 1e3);
            assert!(left.rate.norm() < 1e-12 * rate.norm(), "{} of {rate}", left.rate);
            // the argument along a step is that of the function
            let growth_alone = growth.turning([lambda, lambda * 1.0001].into_iter());
            let other = Complex::new((lambda * 1.0001).im, -(lambda * 1.0001).re).sqrt();
            let turn = other.cosh() * other.cos() / (z.cosh() * z.cos());
            assert_close(growth_alone, argument(turn.re, turn.im), 1.0, 1e4);
        }
    }
}

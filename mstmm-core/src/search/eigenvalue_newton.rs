//! One eigenvalue: Newton's method beside those that are known, and the circle that certifies it.

use super::contour::{Walk, larger};
use super::eigenvalue_search::{EigenvalueSearch, Found};
use super::rectangle::{Rectangle, whole};
use super::region::Eigenvalue;
use crate::characteristic::{Characteristic, System};
use crate::error::SearchError;
use crate::scalar::{Dual, Real, Scalar, modulus};
use num_complex::Complex;

/// Radius of the first circle, relative to the modulus, in units of eps. A certified circle is twice as large as the one
/// along which Δ was seen to turn: room for the rounding of what was seen.
const RADIUS: f64 = 8.0;

/// Around a root a step from corner to corner will do; where much shorter ones do not, rounding rules.
const STEPS_AROUND: [f64; 2] = [0.02, 1.0];

/// The radius grows by this factor until the circle holds the root in spite of rounding.
const GROWTH: f64 = 4.0;

/// Relative radius beyond which no circle is tried: rounding blurs a root of multiplicity 4 to about a tenth of it.
const LARGEST_RADIUS: f64 = 1e-3;

/// Steps of Newton's method: a start that needs more is given up.
const NEWTON_STEPS: u32 = 40;

/// Corners of a regular octagon of radius 1, closed.
const OCTAGON: [(f64, f64); 9] = {
    const H: f64 = core::f64::consts::FRAC_1_SQRT_2;
    [(1.0, 0.0), (H, H), (0.0, 1.0), (-H, H), (-1.0, 0.0), (-H, -H), (0.0, -1.0), (H, -H), (1.0, 0.0)]
};

impl<'a, T, Y> EigenvalueSearch<'a, Y>
where
    T: Real,
    Y: System<Parameter = T> + Characteristic<Dual<Complex<T>>> + ?Sized,
{
    /// A root near a start, other than those that were found; `None` if the steps lead away or do not end.
    ///
    /// Known roots, with their mirror images, are divided out of Δ: `Δ'/Δ - Σ m/(λ - λ_k)`.
    pub(super) fn newton(
        &mut self,
        start: Complex<T>,
        rectangle: &Rectangle<T>,
        found: &Found<T>,
    ) -> Result<Option<Complex<T>>, SearchError> {
        let (mut lambda, mut last, mut is_slow) = (start, T::zero(), false);
        let (eps, coarse) = (T::from_f64(0.25 * T::EPSILON), T::from_f64(T::EPSILON).sqrt());
        for _ in 0..NEWTON_STEPS {
            let point = self.evaluation.at(lambda)?;
            if point.is_root {
                return Ok(Some(lambda));
            }
            let mut rate = point.rate;
            for root in found {
                let multiplicity = T::from_f64(root.multiplicity as f64);
                rate -= Complex::from(multiplicity) / (lambda - root.lambda);
                if !root.lambda.im.is_zero() {
                    rate -= Complex::from(multiplicity) / (lambda - root.lambda.conj());
                }
            }
            let mut step = Complex::from(T::one()) / rate;
            if !step.size().is_finite() {
                // at a known root, or where Δ is flat
                return Ok(None);
            }
            // at a root of multiplicity m the steps shrink by 1 - 1/m only
            let shrinkage = (modulus(step) / last).to_f64();
            if is_slow && (0.4..0.95).contains(&shrinkage) {
                step *= T::from_f64(f64::from((1.0 / (1.0 - shrinkage) + 0.5) as u32));
            }
            is_slow = (0.4..0.95).contains(&shrinkage) && !is_slow;
            lambda -= step;
            if rectangle.is_symmetric() && lambda.im < T::zero() {
                lambda = lambda.conj();
            }
            let (size, scale) = (modulus(step), larger(modulus(lambda), self.smallest()));
            // the next step of a quadratic sequence, and the noise of Δ, at which steps no longer shrink
            let next = size * (size / last) * (size / last);
            let is_quadratic = size <= T::from_f64(1e-3) * scale && size * T::from_f64(8.0) < last;
            if (is_quadratic && next <= eps * scale) || (size <= coarse * scale && size + size > last) {
                return Ok(Some(lambda));
            }
            if !rectangle.contains(lambda, rectangle.size()) {
                return Ok(None);
            }
            last = size;
        }
        // slow because the root is multiple, or on the way nowhere
        Ok((last <= T::from_f64(1e-3) * larger(modulus(lambda), self.smallest())).then_some(lambda))
    }

    /// The smallest circle around an estimate along which Δ turns: its turns are the multiplicity.
    pub(super) fn certify(
        &mut self,
        estimate: Complex<T>,
        symmetric: bool,
    ) -> Result<Option<Eigenvalue<T>>, SearchError> {
        let mut root = self.circle(estimate, symmetric)?;
        if let Some(Eigenvalue { lambda, multiplicity: multiplicity @ 2.., .. }) = root {
            // Newton's step for a root of that multiplicity is good where the plain one is slow
            let point = self.evaluation.at(lambda)?;
            let step = Complex::from(T::from_f64(multiplicity as f64)) / point.rate;
            // on the plateau around a multiple root Δ' may vanish, and the step with it lead nowhere
            if !point.is_root
                && step.size().is_finite()
                && let Some(better) = self.circle(lambda - step, symmetric)?
                && better.multiplicity == multiplicity
            {
                root = Some(better);
            }
        }
        Ok(root)
    }

    fn circle(&mut self, estimate: Complex<T>, symmetric: bool) -> Result<Option<Eigenvalue<T>>, SearchError> {
        let scale = larger(modulus(estimate), self.smallest());
        let mut radius = scale * T::from_f64(RADIUS * T::EPSILON);
        while radius < scale * T::from_f64(LARGEST_RADIUS) {
            // what cannot be told from a real root is one: complex ones come in pairs; what cannot be told from zero is zero
            let is_real = symmetric && estimate.im.abs() <= radius;
            let re = if estimate.re.abs() <= radius { T::zero() } else { estimate.re };
            let lambda = if is_real { Complex::from(re) } else { estimate };
            let corner = |(re, im): (f64, f64)| lambda + Complex::new(T::from_f64(re), T::from_f64(im)) * radius;
            if let Walk::Argument(argument) = self.evaluation.walk(&OCTAGON.map(corner), STEPS_AROUND, |_| ())?
                && let Some(multiplicity @ 1..) = whole(argument / core::f64::consts::TAU)
            {
                return Ok(Some(Eigenvalue { lambda, error: radius + radius, multiplicity }));
            }
            radius *= T::from_f64(GROWTH);
        }
        Ok(None)
    }
}

//! Where a search for eigenvalues may look: with a loss factor above the real axis alone, and nowhere near the points at which the stiffness of
//! a member vanishes.

use crate::model::SearchError;
use crate::number::{Dual, Real, Store, larger};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::found::{Eigenvalue, Region};
use crate::search::damped::rectangle::Rectangle;
use crate::search::damped::session::EigenvalueSearch;
use num_complex::Complex;

/// Distance from an essential singularity, as a part of its size, up to which nothing is searched: eigenvalues accumulate about it.
const NEAR: f64 = 0.02;

/// Share of its sides by which a rectangle may grow where its contour meets a root.
const GROWTH: f64 = 0.015;

/// Part of its height by which a rectangle of a whirl that begins at the axis reaches below it, so that real eigenvalues are inside.
const BELOW: f64 = 1.0 / 64.0;

/// Radius of the largest square that keeps away from a singularity at its left, as a part of the distance of that.
const REACH: f64 = 0.96;

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// A rectangle symmetric to the real axis that holds all eigenvalues up to a modulus. It reaches little to the right, since
    /// motions of passive systems do not grow, which those of rotors may; where eigenvalues have no mirror images it reaches as little below the axis, so that it holds
    /// those at zero.
    pub(super) fn square(&self, radius: T) -> Rectangle<T> {
        let little = radius * T::from_f64(0.0625);
        let right = if self.estimates.is_whirl() { radius } else { little };
        let low = if self.known.have_images { -radius } else { -little };
        Rectangle { left: -radius, right, low, high: radius }
    }

    /// The largest radius of such a rectangle, and the error of a search that would have to go on; `None` where nothing limits it.
    pub(super) fn end_of_reach(&self) -> Option<(T, SearchError)> {
        let singularities = self.estimates.singularities()?;
        Some((T::from_f64(-singularities[0] * REACH), accumulation(singularities)))
    }

    /// The rectangle to be searched for a region; symmetric to the real axis where the region meets it.
    pub(super) fn enclosing(&self, region: &Region<T>) -> Result<Rectangle<T>, SearchError> {
        for range in [&region.re, &region.im] {
            let (start, end) = (*range.start(), *range.end());
            let valid = start < end && (end - start).size().is_finite();
            if !valid {
                return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() });
            }
        }
        let (left, right, low, high) = (*region.re.start(), *region.re.end(), *region.im.start(), *region.im.end());
        let mut rectangle = Rectangle { left, right, low, high };
        let is_whirl = self.estimates.is_whirl() && !self.estimates.has_loss();
        let (is_above, is_at_axis) = (low > T::zero(), is_whirl && low.is_zero() && high > T::zero());
        if is_at_axis {
            // eigenvalues on the axis are of both whirls
            rectangle.low = -(high * T::from_f64(BELOW));
        } else if !(self.known.have_images || is_above) {
            let im = low.to_f64();
            return Err(if is_whirl { SearchError::OtherWhirl { im } } else { SearchError::LossFactor { im } });
        }
        if self.known.have_images && low <= T::zero() && high >= T::zero() {
            rectangle.high = larger(-low, high);
            rectangle.low = -rectangle.high;
        }
        match self.estimates.singularities() {
            Some(singularities) if comes_near(&rectangle, singularities, self.estimates.are_off_axis()) => {
                Err(accumulation(singularities))
            }
            _ => Ok(rectangle),
        }
    }
}

/// Whether a rectangle, as far as it may grow, comes near a point between two singularities, which may be off the real axis.
fn comes_near<T: Real>(rectangle: &Rectangle<T>, [first, last]: [f64; 2], are_off_axis: bool) -> bool {
    let Rectangle { left, right, low, high } = rectangle.grown(GROWTH);
    let [left, right, low, high] = [left, right, low, high].map(T::to_f64);
    // of the farthest point in reach
    let height = -left.max(last) * NEAR;
    let is_high_enough = are_off_axis || low <= height && high >= -height;
    left <= first * (1.0 - NEAR) && right >= last * (1.0 + NEAR) && is_high_enough
}

/// The error of a search that comes near singularities.
fn accumulation([first, last]: [f64; 2]) -> SearchError {
    SearchError::Accumulation { from: last * (1.0 + NEAR), to: first * (1.0 - NEAR) }
}

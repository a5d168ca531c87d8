//! The circles of the eigenvalues that a search found: which are doubtful, and which cannot be told apart.

use crate::model::SearchError;
use crate::number::{CONDITION, Dual, Real, Store, USUAL_ERROR, is_extended, is_last, modulus};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::deflation::meets_any;
use crate::search::damped::found::{Eigenvalue, Region};
use crate::search::damped::rectangle::Rectangle;
use crate::search::damped::session::EigenvalueSearch;
use num_complex::Complex;

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    /// Whether an eigenvalue is doubtful: its circle is wide or holds several, or it is so close to others that rounding moves it farther than
    /// its circle reaches.
    pub(super) fn is_blurred(&self, root: &Eigenvalue<T>) -> bool {
        root.multiplicity > 1 || self.is_wide(root) || self.is_close_to_others(root)
    }

    /// Whether rounding has widened the circle of a root.
    fn is_wide(&self, root: &Eigenvalue<T>) -> bool {
        let scale = self.scale(root.lambda);
        root.error > scale * T::from_f64(USUAL_ERROR * self.precision)
    }

    /// Whether neighbours make a root ill-conditioned: `b²` is large beside `a s`, with the distances a to the nearest root, b to
    /// the next, and s to zero.
    fn is_close_to_others(&self, root: &Eigenvalue<T>) -> bool {
        let scale = self.scale(root.lambda);
        let [nearest, next] = self.distances_to_others(root, scale);
        next * next > nearest * scale * T::from_f64(CONDITION)
    }

    /// The distances to the two nearest other eigenvalues, no larger than that to zero.
    pub(super) fn distances_to_others(&self, root: &Eigenvalue<T>, scale: T) -> [T; 2] {
        let (mut nearest, mut next) = (scale, scale);
        for other in self.known.with_images() {
            let distance = modulus(other.lambda - root.lambda);
            if distance.is_zero() {
                continue;
            }
            if distance < nearest {
                (nearest, next) = (distance, nearest);
            } else if distance < next {
                next = distance;
            }
        }
        [nearest, next]
    }

    /// Refuses circles whose roots no further precision can tell apart: those that meet, those that meet their mirror image, and in
    /// extended precision wide ones on the edge of a region.
    pub(super) fn check_circles(&self, region: Option<&Region<T>>) -> Result<(), SearchError> {
        if !is_last::<T, Y::Parameter>() {
            return Ok(());
        }
        let mut roots = self.known.roots();
        while let [root, others @ ..] = roots {
            let is_cut = is_extended::<T, Y::Parameter>()
                && self.is_wide(root)
                && region.is_some_and(|region| is_on_edge(root, region));
            let is_near_axis = root.lambda.im > T::zero() && root.lambda.im <= root.error;
            if is_cut || is_near_axis || meets_any(root, others) {
                return Err(SearchError::Unresolved { near: root.frequency().to_f64() });
            }
            roots = others;
        }
        Ok(())
    }

    /// Whether the search has an extended precision to turn to.
    pub(super) fn may_ask_extended(&self) -> bool {
        Y::Parameter::HAS_EXTENDED && !is_extended::<T, Y::Parameter>()
    }

    /// Whether the search has to be repeated in extended precision.
    pub(super) fn asks_extended(&self) -> bool {
        self.may_ask_extended() && self.evaluation.is_doubtful
    }
}

/// Whether the circle of a root is partly in a closed region and partly out of it.
fn is_on_edge<T: Real>(root: &Eigenvalue<T>, region: &Region<T>) -> bool {
    belongs(root, region) && !bounding(region).contains(root.lambda, -root.error)
}

/// Whether an eigenvalue belongs to a closed region, as far as its certified circle tells.
pub(super) fn belongs<T: Real>(root: &Eigenvalue<T>, region: &Region<T>) -> bool {
    bounding(region).contains(root.lambda, root.error)
}

/// The rectangle of a region.
fn bounding<T: Real>(Region { re, im }: &Region<T>) -> Rectangle<T> {
    Rectangle { left: *re.start(), right: *re.end(), low: *im.start(), high: *im.end() }
}

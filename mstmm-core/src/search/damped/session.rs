//! The state of a search for eigenvalues.

use crate::model::FrequencyEstimates;
use crate::number::{Dual, Real, Scalar, Store, larger, modulus};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::damped::deflation::KnownRoots;
use crate::search::damped::evaluation::Evaluation;
use crate::search::damped::found::Eigenvalue;
use crate::search::damped::rectangle::Rectangle;
use num_complex::Complex;

/// Radius, in roots of eps, of a circle that the rounding of a double root explains.
const BLUR: f64 = 64.0;

/// Size of a rectangle, in radii of such a circle, up to which its roots are not sought from nearer by.
const NEAR: f64 = 8.0;

/// A search in progress.
pub(super) struct EigenvalueSearch<'a, Y: System + ?Sized, T: Real, K> {
    pub(super) evaluation: Evaluation<'a, Y>,
    /// The eigenvalues found so far, wherever they lie.
    pub(super) known: KnownRoots<T, K>,
    pub(super) estimates: FrequencyEstimates,
    /// Frequencies up to this size count as zero.
    pub(super) smallest: T,
    /// The unit in the last place of the parameters, to which results are good.
    pub(super) precision: f64,
}

impl<'a, T, Y, K> EigenvalueSearch<'a, Y, T, K>
where
    T: Real,
    K: Store<Eigenvalue<T>>,
    Y: System + Characteristic<Dual<Complex<T>>> + Characteristic<Dual<Complex<T::Extended>>> + ?Sized,
{
    pub(super) fn new(system: &'a Y) -> Self {
        let estimates = system.frequency_estimates();
        let smallest = T::one().times_power_of_two(estimates.negligible_exponent());
        let precision = <Y::Parameter as Scalar>::EPSILON;
        EigenvalueSearch {
            evaluation: Evaluation::new(system, &estimates),
            known: KnownRoots::new(estimates.have_images()),
            estimates,
            smallest,
            precision,
        }
    }

    /// The modulus of an eigenvalue, but at least the size up to which frequencies count as zero.
    pub(super) fn scale(&self, lambda: Complex<T>) -> T {
        larger(modulus(lambda), self.smallest)
    }

    /// Whether a circle with several roots is wider than rounding makes that of a double root, in a rectangle that is much wider.
    /// From nearer by its roots may be told apart.
    pub(super) fn may_be_a_cluster(&self, root: &Eigenvalue<T>, rectangle: &Rectangle<T>) -> bool {
        let scale = self.scale(root.lambda);
        let is_wide =
            root.multiplicity > 1 && root.error > scale * T::from_f64(BLUR) * T::from_f64(self.precision).sqrt();
        is_wide && rectangle.size() > root.error * T::from_f64(NEAR)
    }
}

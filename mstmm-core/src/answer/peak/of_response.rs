//! Peaks of responses of trees and of frames.

use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::network::response::PlaneResponse;
use crate::answer::peak::result::{Peak, least, peak};
use crate::answer::root::Root;
use crate::model::{FrequencyEstimates, MotionError, PeakError, SearchError};
use crate::number::{Oscillation, Real, Scalar, modulus};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, PlaneFrequency};
use crate::pass::searched::Spectrum;
use crate::pass::tree::ExtendedTree;
use crate::search::ClosedRange;
use crate::search::damped::eigenvalues::Eigenvalues;
use crate::search::damped::found::{Eigenvalue, Region};
use crate::search::damped::peak::source::{ListedPole, Source};
use num_complex::Complex;

/// What rounding leaves of a response that symmetry makes zero, in units of the precision it is computed in and in its size.
const ROUNDINGS: f64 = 4096.0;

/// A response of a system whose eigenvalues can be counted.
pub trait BandResponse {
    /// The numbers of its system.
    type Number: Real;

    /// The response at λ.
    #[doc(hidden)]
    fn at_lambda(&self, lambda: Complex<Self::Number>) -> Result<Complex<Self::Number>, MotionError>;

    /// A size compared with which its rounding is small.
    #[doc(hidden)]
    fn size_at(&self, lambda: Complex<Self::Number>) -> Result<f64, MotionError>;

    /// Number of eigenvalues in a region.
    #[doc(hidden)]
    fn eigenvalues_in(&self, region: Region<Self::Number>) -> Result<u64, SearchError>;

    /// Estimates of the system.
    #[doc(hidden)]
    fn estimates(&self) -> FrequencyEstimates;

    /// Whether both are responses of one system.
    #[doc(hidden)]
    fn is_of_the_same(&self, other: &Self) -> bool;
}

/// A response, or two of one system, with the list of its roots.
pub(super) struct Listed<'r, R, Q> {
    pub(super) response: &'r R,
    pub(super) divisor: Option<&'r R>,
    pub(super) roots: &'r [Q],
}

/// A complex number in the numbers of a model.
pub(super) fn exactly<T: Real>(z: Complex<f64>) -> Complex<T> {
    Complex::new(T::from_f64(z.re), T::from_f64(z.im))
}

/// A complex number in `f64`.
pub(super) fn plainly<T: Real>(z: Complex<T>) -> Complex<f64> {
    Complex::new(z.re.to_f64(), z.im.to_f64())
}

/// What rounding may leave of a response that symmetry makes zero; nothing is known where its size is not.
pub(super) fn noise_at<T: Real>(response: &impl BandResponse<Number = T>, lambda: Complex<f64>) -> f64
where
    Complex<T>: Oscillation<T>,
{
    let unit = ROUNDINGS * <<Complex<T> as Oscillation<T>>::Extended as Scalar>::EPSILON;
    response.size_at(exactly(lambda)).map_or(0.0, |size| if size.is_finite() { unit * size } else { 0.0 })
}

/// An eigenvalue as a pole in `f64`.
pub(super) fn listed<T: Real>(root: &Eigenvalue<T>) -> ListedPole {
    let lambda = plainly(root.lambda);
    let radius = root.error.to_f64() + f64::EPSILON * modulus(lambda);
    ListedPole { lambda, radius, multiplicity: root.multiplicity }
}

impl<T, R, Q> Source for Listed<'_, R, Q>
where
    T: Real,
    Complex<T>: Oscillation<T>,
    R: BandResponse<Number = T>,
    Q: Root<T>,
{
    fn is_ratio(&self) -> bool {
        self.divisor.is_some()
    }

    fn values(&self, lambda: Complex<f64>) -> Result<[Complex<f64>; 2], MotionError> {
        let lambda = exactly(lambda);
        let divisor = match self.divisor {
            Some(divisor) => plainly(divisor.at_lambda(lambda)?),
            None => Complex::from(1.0),
        };
        Ok([plainly(self.response.at_lambda(lambda)?), divisor])
    }

    fn noise(&self, lambda: Complex<f64>) -> [f64; 2] {
        [noise_at(self.response, lambda), self.divisor.map_or(0.0, |divisor| noise_at(divisor, lambda))]
    }

    fn for_each_pole(&self, hand_on: &mut dyn FnMut(ListedPole)) {
        let have_images = self.response.estimates().have_images();
        for root in self.roots {
            let root = root.eigenvalue();
            let pole = listed(&root);
            let is_image = |other: &Q| {
                let other = other.eigenvalue();
                other.lambda.im > T::zero() && modulus(other.lambda.conj() - root.lambda) <= other.error + root.error
            };
            let has_image = have_images && pole.lambda.im != 0.0;
            if has_image && pole.lambda.im < 0.0 && self.roots.iter().any(is_image) {
                continue;
            }
            hand_on(pole);
            if has_image {
                hand_on(ListedPole { lambda: pole.lambda.conj(), ..pole });
            }
        }
    }

    fn check_box(&self, region: &Region<f64>, listed: u64) -> Result<(), PeakError> {
        let counted = self.response.eigenvalues_in(region.clone().map(T::from_f64))?;
        let omega = 0.5 * (region.im.start() + region.im.end());
        if counted == listed { Ok(()) } else { Err(PeakError::Resonance { omega }) }
    }
}

/// What peaks ask of a kind of response, its peak and its least value.
macro_rules! peaks {
    ($response:ident where $number:ident, $system:ident $(#[doc = $doc:literal])*) => {
        impl<T, Y> BandResponse for $response<'_, Y>
        where
            T: Real,
            Complex<T>: $number<T>,
            Y: $system<Complex<T>> + System<Parameter = T> + Spectrum,
        {
            type Number = T;

            fn at_lambda(&self, lambda: Complex<T>) -> Result<Complex<T>, MotionError> {
                self.at(lambda)
            }

            fn size_at(&self, lambda: Complex<T>) -> Result<f64, MotionError> {
                Ok(self.sized(lambda)?.size)
            }

            fn eigenvalues_in(&self, region: Region<T>) -> Result<u64, SearchError> {
                self.system().count_in(region)
            }

            fn estimates(&self) -> FrequencyEstimates {
                self.system().frequency_estimates()
            }

            fn is_of_the_same(&self, other: &Self) -> bool {
                core::ptr::eq(self.system(), other.system())
            }
        }

        impl<T, Y> $response<'_, Y>
        where
            T: Real,
            Complex<T>: $number<T>,
            Y: $system<Complex<T>> + System<Parameter = T> + Spectrum,
        {
            /// The largest size `|H(iω)|` over a range of ω [rad/s], between two bounds: `lower` was found at `omega`, and nowhere in the range the response is
            /// larger than `upper`, which is `1 + tolerance` times as large.
            ///
            /// `roots` are natural frequencies or eigenvalues in the band and about it. They are where the response is looked at first, and are divided
            /// out of it. A root that the list lacks costs evaluations and nothing else.
            ///
            $(#[doc = $doc])*
            ///
            /// **What the upper bound rests on.** It is checked and not proven. The response without its poles is a polynomial on pieces of the band, with an error that a theorem bounds. It takes that no pole is
            /// left near the piece: [`count_in`](crate::search::Eigenvalues::count_in) counts them, by the argument principle. It takes the largest value on an ellipse about the piece, of which 16 values are
            /// known and four times their largest is taken; and the rounding of the response, of which no bound is known. Of a response that symmetry makes
            /// zero `upper` is what rounding may leave of it.
            ///
            /// # Errors
            /// [`PeakError::Resonance`] for a root without damping in the range, in the list or not; [`PeakError::Tolerance`] for a tolerance below 1e-12 or above
            /// 0.5; [`PeakError::Motion`] with [`MotionError::Range`] for a range that is empty, reversed or not finite; [`PeakError::Search`] where nothing can be
            /// counted, as from zero on where something has a loss factor; [`PeakError::Unresolved`] where rounding hides the response;
            /// [`PeakError::Effort`] for a band with thousands of modes.
            ///
            /// # Source
            /// Levels that are raised until none is met are those of Boyd, Balakrishnan and Kabamba, and of Bruinsma and Steinbuch, for systems of few states; polynomials
            /// in Chebyshev points: Trefethen, *Approximation Theory and Approximation Practice*, theorem 8.2.
            pub fn peak(
                &self,
                range: impl ClosedRange<T>,
                roots: &[impl Root<T>],
                tolerance: f64,
            ) -> Result<Peak<T>, PeakError> {
                peak(&Listed { response: self, divisor: None, roots }, range, tolerance)
            }

            /// The least size `|H(iω)|` over a range of ω [rad/s], as [`peak`](Self::peak) has the largest: `upper` was found at `omega`, and nowhere in the range
            /// the response is smaller than `lower`. Both are 0 where the response of an undamped system changes its sign, and `lower` is where
            /// rounding hides how small the response is.
            ///
            /// # Errors
            /// As [`peak`](Self::peak).
            pub fn least(
                &self,
                range: impl ClosedRange<T>,
                roots: &[impl Root<T>],
                tolerance: f64,
            ) -> Result<Peak<T>, PeakError> {
                least(&Listed { response: self, divisor: None, roots }, range, tolerance)
            }
        }
    };
}

peaks!(FrequencyResponse where Oscillation, ExtendedTree
    /// ```
    /// use mstmm_core::elements::{Mass, SpringDamper};
    /// use mstmm_core::search::Eigenvalues;
    /// use mstmm_core::{AnyElement, ListStep, ModalAnalysis, Room, StepList, Support};
    ///
    /// let steps = [
    ///     ListStep::Tip(Support::Fixed),
    ///     ListStep::Element(AnyElement::try_from(SpringDamper { stiffness: 25.0_f64, damping: 0.2 })?),
    ///     ListStep::Element(Mass { mass: 1.0 }.try_into()?),
    ///     ListStep::Root(Support::Free),
    /// ];
    /// let mut room = Room::<8>::new();
    /// let oscillator = StepList::new(&steps)?.planned(&mut room)?;
    /// let mass = oscillator.label(2).ok_or("no mass")?.output();
    /// let roots = oscillator.first_eigenvalues::<1>()?;
    /// let response = oscillator.frequency_response(mass.force(), mass.deflection())?;
    /// let peak = response.peak(0.0..=20.0, &roots, 1e-8)?;
    /// // of an oscillator 1/(c sqrt(ω² - (c/2m)²))
    /// let exact = 1.0 / (0.2 * (25.0_f64 - 0.01).sqrt());
    /// assert!(peak.lower <= exact && exact <= peak.upper && peak.upper < peak.lower * 1.000_000_02);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
);
peaks!(PlaneResponse where PlaneFrequency, MovingNetwork
    /// ```
    /// use mstmm_core::elements::SpringDamper;
    /// use mstmm_core::frame::{Frame, Ground};
    /// use mstmm_core::search::{Eigenvalues, Region};
    /// use mstmm_core::FrameAnalysis;
    ///
    /// let mut frame = Frame::new();
    /// let point = frame.point(0.0);
    /// frame.member(point, Ground, SpringDamper { stiffness: 25.0, damping: 0.2 });
    /// frame.mass(point, 1.0);
    /// let oscillator = frame.build_damped()?;
    /// let roots = oscillator.eigenvalues_in(Region { re: -5.0..=0.0, im: 0.0..=20.0 })?;
    /// let response = oscillator.frequency_response(point.force_y(), point.displacement_y())?;
    /// let peak = response.peak(0.0..=20.0, &roots, 1e-8)?;
    /// // of an oscillator 1/(c sqrt(ω² - (c/2m)²))
    /// let exact = 1.0 / (0.2 * (25.0_f64 - 0.01).sqrt());
    /// assert!(peak.lower <= exact && exact <= peak.upper && peak.upper < peak.lower * 1.000_000_02);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
);

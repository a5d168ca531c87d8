//! Peaks of exact responses with damping in proportion.
//!
//! A pole λ of such a response has `λ² + α λ = -(1 + β λ)(1 + iη) ω_n²` with a natural frequency ω_n. So the box of a piece, in which `|λ| <= L` and `Re λ >= -r`, holds no pole of
//! a frequency beyond `L (L + α)/(1 - β r)`, the largest of its square.

use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::modal::exact::ExactResponse;
use crate::answer::network::response::PlaneResponse;
use crate::answer::peak::of_response::{BandResponse, exactly, listed, noise_at, plainly};
use crate::answer::peak::result::{Peak, least, peak};
use crate::model::{MotionError, PeakError, SearchError};
use crate::number::{InLanes, Oscillation, Real, Scalar, modulus};
use crate::pass::characteristic::System;
use crate::pass::network::{MovingNetwork, PlaneFrequency};
use crate::pass::searched::Spectrum;
use crate::pass::tree::ExtendedTree;
use crate::search::damped::found::Region;
use crate::search::damped::peak::source::{ListedPole, Source};
use crate::search::{ClosedRange, NaturalFrequencies, NaturalFrequency, ProportionalDamping, Undamped};
use num_complex::Complex;

/// Factor on the square of the frequency up to which the list has to be complete: roundings of that square.
const BEYOND: f64 = 1.0 + 1e-12;

/// An exact response of a system without damping whose natural frequencies are counted.
pub trait CountedResponse<T: Real>: ExactResponse<T> + BandResponse<Number = T> {
    /// Number of natural frequencies below ω.
    #[doc(hidden)]
    fn modes_below(&self, omega: T) -> Result<u64, SearchError>;
}

impl<T, Y> CountedResponse<T> for FrequencyResponse<'_, Y>
where
    T: Real + InLanes,
    Complex<T>: Oscillation<T>,
    Y: ExtendedTree<Complex<T>> + System<Parameter = T> + Spectrum + Undamped,
{
    fn modes_below(&self, omega: T) -> Result<u64, SearchError> {
        self.system().count_below(omega)
    }
}

impl<T, Y> CountedResponse<T> for PlaneResponse<'_, Y>
where
    T: Real + InLanes,
    Complex<T>: PlaneFrequency<T>,
    Y: MovingNetwork<Complex<T>> + System<Parameter = T> + Spectrum + Undamped,
{
    fn modes_below(&self, omega: T) -> Result<u64, SearchError> {
        self.system().count_below(omega)
    }
}

/// A response with damping in proportion, with the natural frequencies of its system.
struct Damped<'r, T, R> {
    damping: &'r ProportionalDamping<T>,
    exact: &'r R,
    roots: &'r [NaturalFrequency<T>],
}

impl<T, R> Source for Damped<'_, T, R>
where
    T: Real,
    Complex<T>: Oscillation<T>,
    R: CountedResponse<T>,
{
    fn is_ratio(&self) -> bool {
        false
    }

    fn values(&self, lambda: Complex<f64>) -> Result<[Complex<f64>; 2], MotionError> {
        Ok([plainly(self.damping.response(self.exact, exactly(lambda))?), Complex::from(1.0)])
    }

    fn noise(&self, lambda: Complex<f64>) -> [f64; 2] {
        [noise_at(self.exact, lambda), 0.0]
    }

    fn for_each_pole(&self, hand_on: &mut dyn FnMut(ListedPole)) {
        for root in self.roots {
            self.damping.eigenvalues(root).iter().flatten().for_each(|root| hand_on(listed(root)));
        }
    }

    fn check_box(&self, region: &Region<f64>, _: u64) -> Result<(), PeakError> {
        let (alpha, beta) = (self.damping.of_inertias().to_f64(), self.damping.of_stiffnesses().to_f64());
        let im = *region.im.start();
        if !self.damping.loss_factor().is_zero() && im <= 0.0 {
            return Err(SearchError::LossFactor { im }.into());
        }
        let left = -region.re.start();
        let height = region.im.start().abs().max(region.im.end().abs());
        let size = modulus(Complex::new(left, height));
        let late = 1.0 - beta * left;
        if late <= 0.0 {
            return Err(SearchError::Accumulation { from: -1.0 / beta, to: -1.0 / beta }.into());
        }
        let below = Scalar::sqrt(size * (size + alpha) / late * BEYOND);
        let limit = T::from_f64(below);
        let counted = self.exact.modes_below(limit)?;
        let listed = self.roots.iter().filter(|root| root.omega < limit).map(|root| root.multiplicity).sum();
        if counted == listed { Ok(()) } else { Err(PeakError::Missing { below, counted, listed }) }
    }
}

impl<T: Real> ProportionalDamping<T> {
    /// The largest size over a range of ω [rad/s] of the exact response of a system that is damped in proportion, as [`peak`](FrequencyResponse::peak) has that of
    /// other responses. `roots` are the natural frequencies of the system without damping from the first one on, up to the band and at least one beyond.
    /// That the list has all of them is proven, by [`count_below`](NaturalFrequencies::count_below).
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::{NaturalFrequencies, ProportionalDamping};
    /// use mstmm_core::{FrameAnalysis, Support};
    ///
    /// let mut frame = Frame::new();
    /// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    /// frame.hold(foot, Support::Fixed);
    /// frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    /// let cantilever = frame.build()?;
    /// let roots = cantilever.frequencies(6)?;
    /// let exact = cantilever.frequency_response(tip.force_y(), tip.displacement_y())?;
    /// let damping = ProportionalDamping::new(0.1, 1e-3, 0.0)?;
    /// let peak = damping.peak(&exact, 0.1..=roots[2].omega, &roots, 1e-6)?;
    /// assert!((peak.omega / roots[0].omega - 1.0).abs() < 1e-2 && peak.upper <= peak.lower * 1.000_002);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`PeakError::Missing`] for a list that is not complete; else as [`peak`](FrequencyResponse::peak), and as [`response`](Self::response).
    pub fn peak(
        &self,
        exact: &impl CountedResponse<T>,
        range: impl ClosedRange<T>,
        roots: &[NaturalFrequency<T>],
        tolerance: f64,
    ) -> Result<Peak<T>, PeakError>
    where
        Complex<T>: Oscillation<T>,
    {
        peak(&Damped { damping: self, exact, roots }, range, tolerance)
    }

    /// The least size of such a response over a range of ω [rad/s].
    ///
    /// # Errors
    /// As [`peak`](Self::peak).
    pub fn least(
        &self,
        exact: &impl CountedResponse<T>,
        range: impl ClosedRange<T>,
        roots: &[NaturalFrequency<T>],
        tolerance: f64,
    ) -> Result<Peak<T>, PeakError>
    where
        Complex<T>: Oscillation<T>,
    {
        least(&Damped { damping: self, exact, roots }, range, tolerance)
    }
}

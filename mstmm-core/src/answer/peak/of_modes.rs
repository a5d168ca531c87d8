//! Peaks of sums over modes: all of their poles are known.

use crate::answer::modal::response::ModalResponse;
use crate::answer::peak::of_response::{exactly, plainly};
use crate::answer::peak::result::{Peak, least, peak};
use crate::model::{MotionError, PeakError};
use crate::number::Real;
use crate::search::ClosedRange;
use crate::search::damped::found::Region;
use crate::search::damped::peak::source::{ListedPole, Source};
use num_complex::Complex;

impl<T: Real, const N: usize, M> Source for ModalResponse<T, N, M> {
    fn is_ratio(&self) -> bool {
        false
    }

    fn values(&self, lambda: Complex<f64>) -> Result<[Complex<f64>; 2], MotionError> {
        Ok([plainly(self.whole_at(exactly(lambda))?), Complex::from(1.0)])
    }

    /// A sum is what its terms are.
    fn noise(&self, _: Complex<f64>) -> [f64; 2] {
        [0.0; 2]
    }

    fn for_each_pole(&self, hand_on: &mut dyn FnMut(ListedPole)) {
        let mut simple = |lambda: Complex<f64>| hand_on(ListedPole { lambda, radius: 0.0, multiplicity: 1 });
        for term in &self.terms {
            let lambda = plainly(term.lambda);
            simple(lambda);
            if lambda.im != 0.0 {
                simple(lambda.conj());
            }
        }
        if !self.lag.is_zero() {
            simple(Complex::from(-1.0 / self.lag.to_f64()));
        }
        if !self.away().is_zero() {
            hand_on(ListedPole { lambda: Complex::from(0.0), radius: 0.0, multiplicity: 2 });
        }
    }

    /// All poles of a sum are in its list.
    fn check_box(&self, _: &Region<f64>, _: u64) -> Result<(), PeakError> {
        Ok(())
    }
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The largest size of the sum over a range of ω [rad/s], as [`peak`](crate::FrequencyResponse::peak) has that of an exact response; its upper bound rests on no count, since
    /// all poles of the sum are known.
    ///
    /// It is the peak of the sum. The exact response differs from it by no more than what the list leaves out: the peak of that is up to the bound of
    /// [`Truncation`](crate::Truncation) at the end of the range away.
    ///
    /// ```
    /// use mstmm_core::frame::{Frame, Section};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{FrameAnalysis, Support};
    ///
    /// let mut frame = Frame::new();
    /// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
    /// frame.hold(foot, Support::Fixed);
    /// frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
    /// let cantilever = frame.build()?;
    /// let roots = cantilever.frequencies(4)?;
    /// let sum = cantilever.modal_response::<4, _>(&roots, tip.force_y(), tip.displacement_y())?.with_damping_ratio(0.02)?;
    /// let peak = sum.peak(0.0..=roots[2].omega, 1e-6)?;
    /// // that of the first mode, some 1/2ζ times its static value
    /// let share = peak.lower / sum.static_value()?;
    /// assert!(share > 24.0 && share < 25.0 && (peak.omega / roots[0].omega - 1.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`PeakError::Resonance`] for a mode without damping in the range; else as [`peak`](crate::FrequencyResponse::peak).
    pub fn peak(&self, range: impl ClosedRange<T>, tolerance: f64) -> Result<Peak<T>, PeakError> {
        peak(self, range, tolerance)
    }

    /// The least size of the sum over a range of ω [rad/s].
    ///
    /// # Errors
    /// As [`peak`](Self::peak).
    pub fn least(&self, range: impl ClosedRange<T>, tolerance: f64) -> Result<Peak<T>, PeakError> {
        least(self, range, tolerance)
    }
}

//! The peak of a response over a band.

use crate::model::{PeakError, turns};
use crate::number::{Real, Scalar};
use crate::search::ClosedRange;
use crate::search::damped::peak::search::{Extreme, Largest, largest};
use crate::search::damped::peak::source::Source;
use core::ops::RangeInclusive;

/// Units of rounding by which the ends of an interval are moved outwards: those of a response and of its modulus.
const OUTWARDS: f64 = 16.0;

/// The largest size of a response over a band, or the least, between two bounds.
///
/// The bounds are checked and not proven: beside a theorem they rest on a count, on samples of the response about the band, and on a number of roundings.
/// [`FrequencyResponse::peak`](crate::FrequencyResponse::peak) names all three.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak<T = f64> {
    /// The angular frequency ω [rad/s] at which the response was found to be so large, or so small.
    pub omega: T,
    /// A lower bound of the peak, or of the least value.
    pub lower: T,
    /// An upper bound of it: at no frequency of the band the response is larger than a peak.
    pub upper: T,
    /// How often a response was evaluated.
    pub evaluations: usize,
}

impl<T: Real> Peak<T> {
    /// Frequency `ω/2π` in hertz.
    ///
    /// ```
    /// use mstmm_core::Peak;
    ///
    /// assert_eq!(Peak { omega: std::f64::consts::TAU * 25.0, ..Peak::default() }.hertz(), 25.0);
    /// ```
    pub fn hertz(&self) -> T {
        turns::in_hertz(self.omega)
    }
}

/// The extreme of a response over a range of ω.
pub(super) fn extreme<T: Real>(
    source: &dyn Source,
    range: &RangeInclusive<T>,
    extreme: Extreme,
    tolerance: f64,
) -> Result<Peak<T>, PeakError> {
    let range = range.start().to_f64()..=range.end().to_f64();
    let Largest { omega, found, bound, evaluations } = largest(source, &range, extreme, tolerance)?;
    let [down, up] = [1.0 - OUTWARDS * f64::EPSILON, 1.0 + OUTWARDS * f64::EPSILON];
    let [lower, upper] = match extreme {
        Extreme::Peak if bound.is_finite() => [found * down, bound * up],
        Extreme::Peak => return Err(PeakError::Infinite { omega }),
        Extreme::Least => [down / bound, up / found],
    };
    let [omega, lower, upper] = [omega, lower, upper].map(<T as Scalar>::from_f64);
    Ok(Peak { omega, lower, upper, evaluations })
}

/// The peak over a range.
pub(super) fn peak<T: Real>(
    source: &dyn Source,
    range: impl ClosedRange<T>,
    tolerance: f64,
) -> Result<Peak<T>, PeakError> {
    extreme(source, &range.closed(), Extreme::Peak, tolerance)
}

/// The least value over a range.
pub(super) fn least<T: Real>(
    source: &dyn Source,
    range: impl ClosedRange<T>,
    tolerance: f64,
) -> Result<Peak<T>, PeakError> {
    extreme(source, &range.closed(), Extreme::Least, tolerance)
}

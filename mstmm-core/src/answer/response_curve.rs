//! Response curves: samples that are denser where the curve bends.

use crate::answer::frequency_response::FrequencyResponse;
use crate::answer::root::Root;
use crate::model::{MotionError, turns};
use crate::number::{List, Oscillation, Real, Scalar, sort_by};
use crate::pass::characteristic::System;
use crate::pass::tree::{ExtendedTree, Planned};
use crate::search::ClosedRange;
use core::ops::RangeInclusive;

/// Number of intervals of a curve before it is refined.
const INTERVALS: u32 = 16;
/// Smallest gap between samples, as a part of the range, unless a resonance is narrower.
const FINEST: f64 = 1e-4;

/// A sample of a response curve.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample<T, S> {
    /// Angular frequency ω [rad/s].
    pub omega: T,
    /// The response there.
    pub value: S,
    /// Whether the curve is straight enough up to the next sample.
    is_settled: bool,
}

impl<T: Real, S> Sample<T, S> {
    /// Frequency `ω/2π` in hertz.
    pub fn hertz(&self) -> T {
        turns::in_hertz(self.omega)
    }
}

impl<Y: Planned + ?Sized> FrequencyResponse<'_, Y> {
    /// The response over a range of ω [rad/s], refined where it bends: between two samples it differs from the straight line at
    /// the middle by no more than `tolerance` times the largest of the three.
    ///
    /// `roots` are the roots whose resonances may lie in the range: none of them is missed, however narrow. Undamped resonances are
    /// infinite and are approached to 1e-4 of the range.
    ///
    /// A thread of 256 kB, 512 in debug builds, and four times the list of samples is enough.
    ///
    /// # Errors
    /// [`MotionError::Capacity`] for more than `CAP` samples; [`MotionError::Range`] for a range that is empty, reversed or not
    /// finite; [`MotionError::Tolerance`] for a tolerance that is not positive; else as [`at`](FrequencyResponse::at).
    pub fn curve<const CAP: usize, S>(
        &self,
        range: impl ClosedRange<Y::Parameter>,
        roots: &[impl Root<Y::Parameter, Frequency = S>],
        tolerance: f64,
    ) -> Result<List<Sample<Y::Parameter, S>, CAP>, MotionError>
    where
        Y: ExtendedTree<S>,
        S: Oscillation<<Y as System>::Parameter>,
    {
        refined(|x| self.at(x), &range.closed(), roots.iter().map(Root::peak), tolerance)
    }
}

/// A response over a range of ω, refined where it bends, given the frequency and half the width of each resonance.
pub(crate) fn refined<const CAP: usize, T: Real, S: Oscillation<T>>(
    at: impl Fn(S) -> Result<S, MotionError>,
    range: &RangeInclusive<T>,
    peaks: impl IntoIterator<Item = (T, T)>,
    tolerance: f64,
) -> Result<List<Sample<T, S>, CAP>, MotionError> {
    let (start, end) = (range.start().to_f64(), range.end().to_f64());
    if !(start < end && (end - start).is_finite()) {
        return Err(MotionError::Range { start, end });
    }
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(MotionError::Tolerance { tolerance });
    }
    let mut curve = Refinement { at, samples: List::new() };
    for interval in 0..=INTERVALS {
        let share = f64::from(interval) / f64::from(INTERVALS);
        curve.add(start * (1.0 - share) + end * share)?;
    }
    let mut finest = FINEST * (end - start);
    for (omega, width) in peaks {
        let (omega, width) = (omega.to_f64(), width.to_f64());
        let places = [omega - width, omega, omega + width];
        for place in places.into_iter().filter(|place| width > 0.0 && (start..=end).contains(place)) {
            curve.add(place)?;
            finest = finest.min(width / 4.0);
        }
    }
    curve.refine(finest, tolerance)?;
    Ok(curve.samples)
}

/// A curve while it is refined.
struct Refinement<F, T, S, const CAP: usize> {
    at: F,
    samples: List<Sample<T, S>, CAP>,
}

impl<F, T, S, const CAP: usize> Refinement<F, T, S, CAP>
where
    F: Fn(S) -> Result<S, MotionError>,
    T: Real,
    S: Oscillation<T>,
{
    /// Adds the sample at ω in its place, unless it is infinite or uncertain.
    fn add(&mut self, omega: f64) -> Result<(), MotionError> {
        let omega = Scalar::from_f64(omega);
        match (self.at)(S::of_omega(omega)) {
            Err(MotionError::Resonance { .. } | MotionError::Unsettled { .. }) => Ok(()),
            Err(error) => Err(error),
            Ok(value) => self.insert(Sample { omega, value, is_settled: false }),
        }
    }

    fn insert(&mut self, sample: Sample<T, S>) -> Result<(), MotionError> {
        if self.samples.iter().any(|other| other.omega == sample.omega) {
            return Ok(());
        }
        self.samples.push(sample).map_err(|_| MotionError::Capacity { capacity: CAP })?;
        sort_by(self.samples.as_mut_slice(), |a, b| a.omega < b.omega);
        Ok(())
    }

    /// Halves gaps until the curve is straight in each, or they are as fine as they may be.
    fn refine(&mut self, finest: f64, tolerance: f64) -> Result<(), MotionError> {
        let mut index = 0;
        while index + 1 < self.samples.len() {
            let (from, to) = (self.samples[index], self.samples[index + 1]);
            let gap = (to.omega - from.omega).to_f64();
            if from.is_settled || gap <= finest {
                index += 1;
                continue;
            }
            let half = <T as Scalar>::from_f64(0.5);
            let omega = (from.omega + to.omega) * half;
            if omega <= from.omega || omega >= to.omega {
                // no frequency is between the two
                index += 1;
                continue;
            }
            let Ok(value) = (self.at)(S::of_omega(omega)) else {
                // a resonance at the middle
                index += 1;
                continue;
            };
            let straight = (from.value + to.value) * half;
            let largest = from.value.size().max(to.value.size()).max(value.size());
            if (value - straight).size() <= tolerance * largest {
                self.samples.as_mut_slice()[index].is_settled = true;
            } else {
                self.insert(Sample { omega, value, is_settled: false })?;
            }
        }
        Ok(())
    }
}

//! Brackets of a factor: where a proven count grows with it.

use crate::model::SearchError;
use crate::number::{List, Real};
use crate::proof::prover::{Bound, zero_of};
use crate::search::room::add;

/// Upper ends of brackets that wait: each is half of the one before.
const WAITING: usize = 128;

/// Steps of a bracket: the bits of a word, with a step of the secant method before each.
const STEPS: usize = 160;

/// Width of an interval, in units of eps, that holds several crossings or one that rounding cannot narrow: more bisection separates nothing.
const WIDEST: f64 = 4.0;

/// Where a bracket is divided: beside a crossing that is at one of these the next one does.
const SHARES: [f64; 4] = [0.5, 0.44, 0.57, 0.3];

/// Binary exponent of the part of a range below which a factor counts as zero.
const ZERO_EXPONENT: i32 = -60;

/// Where a count grows: at `lower` it is at most `index - 1`, at `upper` at least `index + multiplicity - 1`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Crossing<T> {
    pub(super) factor: T,
    pub(super) lower: T,
    pub(super) upper: T,
    pub(super) multiplicity: u64,
    pub(super) index: u64,
}

/// A factor with bounds of a count, and Δ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<T> {
    pub(super) factor: T,
    pub(super) least: u64,
    pub(super) most: u64,
    pub(super) bound: Option<Bound>,
}

impl<T: Real> Default for Sample<T> {
    fn default() -> Self {
        Sample { factor: T::zero(), least: 0, most: 0, bound: None }
    }
}

/// A search in progress.
struct Search<T, F, E> {
    /// The bounds at a factor.
    sample: F,
    /// The error of a count that falls behind a factor.
    falls: fn(f64) -> E,
    /// The size below which a factor counts as zero.
    least: T,
}

/// Every factor between two ends at which a count grows, given its bounds at a factor, and the error where it falls.
///
/// # Errors
/// That of a sample; [`SearchError`] for a range that is empty or not finite, more than `CAP` factors, or counts that rounding decides.
pub(super) fn crossings<T: Real, E: From<SearchError>, const CAP: usize>(
    [start, end]: [T; 2],
    sample: impl FnMut(T) -> Result<Sample<T>, E>,
    falls: fn(f64) -> E,
) -> Result<List<Crossing<T>, CAP>, E> {
    let is_range = start < end && start.size().is_finite() && end.size().is_finite();
    if !is_range {
        return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() }.into());
    }
    Search { sample, falls, least: (end - start).times_power_of_two(ZERO_EXPONENT) }.all(start, end)
}

impl<T: Real, E: From<SearchError>, F: FnMut(T) -> Result<Sample<T>, E>> Search<T, F, E> {
    fn all<const CAP: usize>(&mut self, start: T, end: T) -> Result<List<Crossing<T>, CAP>, E> {
        let mut found = List::<Crossing<T>, CAP>::new();
        let mut waiting = List::<Sample<T>, WAITING>::new();
        // the ends move outward where a crossing is at them
        let mut lower = self.end(start, false)?;
        let mut upper = self.end(end, true)?;
        loop {
            if upper.most < lower.least {
                return Err((self.falls)(lower.factor.to_f64()));
            }
            let is_empty = upper.most == lower.least;
            let narrow = self.size(upper.factor) * T::from_f64(WIDEST * T::EPSILON);
            let root = if is_empty {
                None
            } else if upper.factor - lower.factor <= narrow {
                Some(interval(&lower, &upper))
            } else if lower.most == lower.least && upper.least == lower.most + 1 && upper.most == upper.least {
                Some(self.single(lower, upper)?)
            } else {
                if let Some(middle) = self.between(&lower, &upper)? {
                    waiting.push(upper).map_err(|lost| unproven(&lost))?;
                    upper = middle;
                    continue;
                }
                if upper.factor - lower.factor > narrow * T::from_f64(SHARES.len() as f64) {
                    return Err(unproven(&upper).into());
                }
                Some(interval(&lower, &upper))
            };
            if let Some(root) = root {
                push(&mut found, root, narrow)?;
            }
            let Some(next) = waiting.pop() else { return Ok(found) };
            (lower, upper) = (upper, next);
        }
    }

    /// A sample between two others whose count is decided, if there is one.
    fn between(&mut self, lower: &Sample<T>, upper: &Sample<T>) -> Result<Option<Sample<T>>, E> {
        for share in SHARES {
            let factor = lower.factor + (upper.factor - lower.factor) * T::from_f64(share);
            if lower.factor < factor && factor < upper.factor {
                let sample = (self.sample)(factor)?;
                if sample.least == sample.most {
                    return Ok(Some(sample));
                }
            }
        }
        Ok(None)
    }

    /// The size of a factor, no less than what counts as zero.
    fn size(&self, factor: T) -> T {
        if factor.abs() > self.least { factor.abs() } else { self.least }
    }

    /// The end of a range; where rounding decides the count there, one beside it.
    fn end(&mut self, factor: T, is_upper: bool) -> Result<Sample<T>, E> {
        let mut sample = (self.sample)(factor)?;
        for steps in [1.0, 2.0, 4.0, 8.0] {
            if sample.least == sample.most {
                return Ok(sample);
            }
            let away = self.size(factor) * T::from_f64(steps * T::EPSILON);
            sample = (self.sample)(if is_upper { factor + away } else { factor - away })?;
        }
        match sample {
            Sample { most: u64::MAX, .. } => Err(unproven(&sample).into()),
            Sample { least, most, .. } if least < most => Err(SearchError::Zero { points: 5, at: None }.into()),
            _ => Ok(sample),
        }
    }

    /// The single crossing of a bracket with proven ends, by the secant method and halves.
    fn single(&mut self, mut lower: Sample<T>, mut upper: Sample<T>) -> Result<Crossing<T>, E> {
        let before = lower.most;
        for step in 0..STEPS {
            let half = lower.factor + (upper.factor - lower.factor) * T::from_f64(0.5);
            let is_between = |factor: T| lower.factor < factor && factor < upper.factor;
            if !is_between(half) {
                break;
            }
            let secant = match (lower.bound, upper.bound) {
                (Some(below), Some(above)) if step % 3 != 2 => {
                    // a unit beside the zero, so that both ends move
                    let zero = zero_of([lower.factor, upper.factor], [below, above]);
                    let unit = self.size(zero) * T::from_f64(T::EPSILON);
                    if step % 3 == 0 { zero + unit } else { zero - unit }
                }
                _ => half,
            };
            let sample = (self.sample)(if is_between(secant) { secant } else { half })?;
            let decided = if sample.least == sample.most { Some(sample) } else { self.between(&lower, &upper)? };
            let Some(sample) = decided else { break };
            if sample.most <= before { lower = sample } else { upper = sample }
        }
        Ok(interval(&lower, &upper))
    }
}

/// The crossings between two proven ends.
fn interval<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> Crossing<T> {
    let factor = match (lower.bound, upper.bound) {
        (Some(below), Some(above)) => zero_of([lower.factor, upper.factor], [below, above]),
        _ => lower.factor,
    };
    let is_between = lower.factor <= factor && factor <= upper.factor;
    let middle = lower.factor + (upper.factor - lower.factor) * T::from_f64(0.5);
    Crossing {
        factor: if is_between { factor } else { middle },
        lower: lower.factor,
        upper: upper.factor,
        multiplicity: upper.least - lower.most,
        index: lower.most + 1,
    }
}

/// Adds crossings; those that are as close to the ones before as one interval is wide are one entry with them.
fn push<T: Real, const CAP: usize>(
    found: &mut List<Crossing<T>, CAP>,
    root: Crossing<T>,
    narrow: T,
) -> Result<(), SearchError> {
    if let Some(last) = found.as_mut_slice().last_mut()
        && root.upper - last.lower <= narrow
    {
        (last.upper, last.multiplicity) = (root.upper, last.multiplicity + root.multiplicity);
        return Ok(());
    }
    add(found, root)
}

/// The error of a count that rounding decides.
fn unproven<T: Real>(sample: &Sample<T>) -> SearchError {
    SearchError::Unproven { near: sample.factor.to_f64(), at_most: sample.most, at_least: sample.least }
}

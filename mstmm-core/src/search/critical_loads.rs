//! Critical loads: the factors of a load at which a structure at rest loses its stability, certified by counts.

use crate::model::{LoadError, ParameterError, SearchError};
use crate::number::{InLanes, List, Parameter, Real, Scalar};
use crate::pass::searched::Undamped;
use crate::proof::prover::{Bound, Prover, zero_of};
use crate::search::closed_range::ClosedRange;
use crate::search::room::add;
use crate::search::undamped::proven::Parts;
use core::ops::Deref;

/// Upper ends of brackets that wait: each is half of the one before.
const WAITING: usize = 128;

/// Steps of a bracket: the bits of a word, with a step of the secant method before each.
const STEPS: usize = 160;

/// Width of an interval, in units of eps, that holds several loads or one that rounding cannot narrow: more bisection separates nothing.
const WIDEST: f64 = 4.0;

/// Where a bracket is divided: beside a load that is at one of these the next one does.
const SHARES: [f64; 4] = [0.5, 0.44, 0.57, 0.3];

/// Binary exponent of the part of a range below which a factor counts as zero.
const ZERO_EXPONENT: i32 = -60;

/// A factor of a load at which stability is lost: of the model at `lower` at most `index - 1` motions grow, of that at `upper` at least
/// `index + multiplicity - 1`. Both counts are proven, whatever the load does between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CriticalLoad<T = f64> {
    /// The load factor.
    pub factor: T,
    /// Lower end of the certified interval.
    pub lower: T,
    /// Upper end of the certified interval.
    pub upper: T,
    /// Number of motions that begin to grow there.
    pub multiplicity: u64,
    /// Index of the first of them, from 1 on: one more than the number of motions that grow under a load just below.
    pub index: u64,
}

/// Critical loads in ascending order; dereferences to a slice.
#[derive(Clone, Copy, Debug)]
pub struct CriticalLoads<T, const CAP: usize>(List<CriticalLoad<T>, CAP>);

impl<T, const CAP: usize> Deref for CriticalLoads<T, CAP> {
    type Target = [CriticalLoad<T>];

    fn deref(&self) -> &[CriticalLoad<T>] {
        &self.0
    }
}

/// Every factor of a range at which the structure under that load begins to have a motion that grows, each certified, with multiplicity.
///
/// The function builds the structure under a factor times the load: its axial forces are proportional to the factor. At rest the count of
/// Wittrick and Williams is that of the negative eigenvalues of the stiffness, which grows with the factor where the load compresses all
/// elements on which it acts; so brackets with counts hold all factors, as brackets of frequencies do.
///
/// # Errors
/// [`LoadError::Parameter`] where the function fails, [`LoadError::Falls`] where fewer motions grow under a larger factor, and
/// [`LoadError::Search`] for a range that is empty or not finite, more than `CAP` factors, or a structure that is not held, whose
/// stiffness has no inverse at any factor.
///
/// # Source
/// Wittrick and Williams for buckling: the count of clamped elements and of signs at ω = 0.
pub fn critical_loads<const CAP: usize, Y: Undamped>(
    factors: impl ClosedRange<Y::Parameter>,
    build: impl FnMut(Y::Parameter) -> Result<Y, ParameterError>,
) -> Result<CriticalLoads<Y::Parameter, CAP>, LoadError> {
    let (start, end) = factors.closed().into_inner();
    let is_range = start < end && start.size().is_finite() && end.size().is_finite();
    if !is_range {
        return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() }.into());
    }
    Search { build, least: (end - start).times_power_of_two(ZERO_EXPONENT) }.all(start, end)
}

/// A factor with bounds of the number of motions that grow, and Δ at rest.
#[derive(Clone, Copy, Debug)]
struct Sample<T> {
    factor: T,
    least: u64,
    most: u64,
    bound: Option<Bound>,
}

impl<T: Real> Default for Sample<T> {
    fn default() -> Self {
        Sample { factor: T::zero(), least: 0, most: 0, bound: None }
    }
}

/// A search in progress.
struct Search<T, F> {
    build: F,
    /// The size below which a factor counts as zero.
    least: T,
}

impl<T: Real + InLanes, F> Search<T, F> {
    fn all<Y, const CAP: usize>(&mut self, start: T, end: T) -> Result<CriticalLoads<T, CAP>, LoadError>
    where
        Y: Undamped<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let mut found = List::<CriticalLoad<T>, CAP>::new();
        let mut waiting = List::<Sample<T>, WAITING>::new();
        // the ends move outward where a load is at them
        let mut lower = self.end::<Y>(start, false)?;
        let mut upper = self.end::<Y>(end, true)?;
        loop {
            if upper.most < lower.least {
                return Err(LoadError::Falls { factor: lower.factor.to_f64() });
            }
            let is_empty = upper.most == lower.least;
            let narrow = self.size(upper.factor) * T::from_f64(WIDEST * T::EPSILON);
            let root = if is_empty {
                None
            } else if upper.factor - lower.factor <= narrow {
                Some(interval(&lower, &upper))
            } else if lower.most == lower.least && upper.least == lower.most + 1 && upper.most == upper.least {
                Some(self.single::<Y>(lower, upper)?)
            } else {
                if let Some(middle) = self.between::<Y>(&lower, &upper)? {
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
            let Some(next) = waiting.pop() else { return Ok(CriticalLoads(found)) };
            (lower, upper) = (upper, next);
        }
    }

    /// A sample between two others whose count is decided, if there is one.
    fn between<Y>(&mut self, lower: &Sample<T>, upper: &Sample<T>) -> Result<Option<Sample<T>>, LoadError>
    where
        Y: Undamped<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        for share in SHARES {
            let factor = lower.factor + (upper.factor - lower.factor) * T::from_f64(share);
            if lower.factor < factor && factor < upper.factor {
                let sample = self.sample::<Y>(factor)?;
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

    /// Bounds of the number of motions that grow under a factor of the load.
    fn sample<Y>(&mut self, factor: T) -> Result<Sample<T>, LoadError>
    where
        Y: Undamped<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let at = factor.to_f64();
        let system = (self.build)(factor).map_err(|error| LoadError::Parameter { factor: at, error })?;
        let parts = Parts(&system);
        let ([least, most], bound) = Prover::new(&parts).bounds_with_delta(T::zero(), 1.0);
        Ok(Sample { factor, least: least.unwrap_or(0), most: most.unwrap_or(u64::MAX), bound: Some(bound) })
    }

    /// The end of a range; where rounding decides how many motions grow there, one beside it.
    fn end<Y>(&mut self, factor: T, is_upper: bool) -> Result<Sample<T>, LoadError>
    where
        Y: Undamped<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let mut sample = self.sample::<Y>(factor)?;
        for steps in [1.0, 2.0, 4.0, 8.0] {
            if sample.least == sample.most {
                return Ok(sample);
            }
            let away = self.size(factor) * T::from_f64(steps * T::EPSILON);
            sample = self.sample::<Y>(if is_upper { factor + away } else { factor - away })?;
        }
        match sample {
            Sample { most: u64::MAX, .. } => Err(unproven(&sample).into()),
            Sample { least, most, .. } if least < most => Err(SearchError::Zero { points: 5, at: None }.into()),
            _ => Ok(sample),
        }
    }

    /// The single load of a bracket with proven ends, by the secant method and halves.
    fn single<Y>(&mut self, mut lower: Sample<T>, mut upper: Sample<T>) -> Result<CriticalLoad<T>, LoadError>
    where
        Y: Undamped<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
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
            let sample = self.sample::<Y>(if is_between(secant) { secant } else { half })?;
            let decided = if sample.least == sample.most { Some(sample) } else { self.between::<Y>(&lower, &upper)? };
            let Some(sample) = decided else { break };
            if sample.most <= before { lower = sample } else { upper = sample }
        }
        Ok(interval(&lower, &upper))
    }
}

/// The loads between two proven ends.
fn interval<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> CriticalLoad<T> {
    let factor = match (lower.bound, upper.bound) {
        (Some(below), Some(above)) => zero_of([lower.factor, upper.factor], [below, above]),
        _ => lower.factor,
    };
    let is_between = lower.factor <= factor && factor <= upper.factor;
    let middle = lower.factor + (upper.factor - lower.factor) * T::from_f64(0.5);
    CriticalLoad {
        factor: if is_between { factor } else { middle },
        lower: lower.factor,
        upper: upper.factor,
        multiplicity: upper.least - lower.most,
        index: lower.most + 1,
    }
}

/// Adds loads; those that are as close to the ones before as one interval is wide are one entry with them.
fn push<T: Real, const CAP: usize>(
    found: &mut List<CriticalLoad<T>, CAP>,
    root: CriticalLoad<T>,
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

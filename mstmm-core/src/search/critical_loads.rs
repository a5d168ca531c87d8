//! Critical loads: the factors of a load at which a structure at rest loses its stability, certified by counts.

use crate::model::{LoadError, ParameterError, SearchError};
use crate::number::{Frequency, List, Parameter, Real, Scalar, Scaled, Single};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::search::closed_range::ClosedRange;
use crate::search::room::add;
use crate::subspace::WittrickWilliams;
use core::ops::Deref;

/// Half the relative width of a certified interval, in units of eps, as that of a frequency.
const HALF_WIDTH: f64 = 16.0;

/// Steps of the secant method within which a bracket has to be halved.
const PATIENCE: u32 = 3;

/// Upper ends of brackets that wait: each is half of the one before.
const WAITING: usize = 128;

/// A factor of a load at which stability is lost, certified by the counts of motions that grow just below and just above it.
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

/// A system at rest whose counts of motions that grow are known, in its own and in extended precision.
pub trait AtRest:
    System + Characteristic<<Self as System>::Parameter> + Characteristic<<<Self as System>::Parameter as Real>::Extended>
{
}

impl<Y> AtRest for Y where
    Y: System
        + Characteristic<<Y as System>::Parameter>
        + Characteristic<<<Y as System>::Parameter as Real>::Extended>
        + ?Sized
{
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
pub fn critical_loads<const CAP: usize, Y: AtRest>(
    factors: impl ClosedRange<Y::Parameter>,
    build: impl FnMut(Y::Parameter) -> Result<Y, ParameterError>,
) -> Result<CriticalLoads<Y::Parameter, CAP>, LoadError> {
    let (start, end) = factors.closed().into_inner();
    let is_range = start < end && start.size().is_finite() && end.size().is_finite();
    if !is_range {
        return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() }.into());
    }
    Search { build, is_extended: false, least: (end - start).times_power_of_two(-60) }.all(start, end)
}

/// A factor with its count and Δ.
#[derive(Clone, Copy, Debug)]
struct Sample<T: Scalar> {
    factor: T,
    below: u64,
    value: Scaled<T>,
}

impl<T: Real> Default for Sample<T> {
    fn default() -> Self {
        Sample { factor: T::zero(), below: 0, value: Scaled::new(T::one(), 0) }
    }
}

/// A search in progress.
struct Search<T, F> {
    build: F,
    /// Whether counts are taken in extended precision.
    is_extended: bool,
    /// The size below which a factor counts as zero.
    least: T,
}

impl<T: Real, F> Search<T, F> {
    /// Half the width of the interval about a factor.
    fn room(&self, factor: T) -> T {
        let size = if factor.abs() > self.least { factor.abs() } else { self.least };
        size * T::from_f64(HALF_WIDTH * T::EPSILON)
    }

    fn all<Y, const CAP: usize>(&mut self, start: T, end: T) -> Result<CriticalLoads<T, CAP>, LoadError>
    where
        Y: AtRest + System<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let mut found = List::<_, CAP>::new();
        let mut lower = self.sample(start)?;
        let mut waiting = List::<Sample<T>, WAITING>::new();
        let mut upper = self.sample(end)?;
        loop {
            let count = grown(&lower, &upper)?;
            let width = upper.factor - lower.factor;
            let root = if count == 0 {
                None
            } else if count == 1 {
                Some(self.certified(lower, upper)?)
            } else if width <= self.room(upper.factor) {
                Some(self.settled(&lower, &upper))
            } else {
                let middle = self.sample(lower.factor + width * T::from_f64(0.5))?;
                waiting.push(upper).map_err(|lost| SearchError::Unresolved { near: lost.factor.to_f64() })?;
                upper = middle;
                continue;
            };
            if let Some(root) = root {
                add(&mut found, root)?;
            }
            let Some(next) = waiting.pop() else { return Ok(CriticalLoads(found)) };
            (lower, upper) = (upper, next);
        }
    }

    /// Count and Δ at rest under a factor of the load; where Δ vanishes, as it does under a critical load that is a round number, under one
    /// beside it.
    fn sample<Y>(&mut self, factor: T) -> Result<Sample<T>, LoadError>
    where
        Y: AtRest + System<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let beside = factor + self.room(factor) * T::from_f64(0.5);
        for factor in [factor, beside] {
            if let Some(sample) = self.evaluated(factor)? {
                return Ok(sample);
            }
        }
        Err(SearchError::Zero { points: 1, at: None }.into())
    }

    /// Count and Δ at rest under a factor of the load; `None` where Δ vanishes.
    fn evaluated<Y>(&mut self, factor: T) -> Result<Option<Sample<T>>, LoadError>
    where
        Y: AtRest + System<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let at = factor.to_f64();
        let system = (self.build)(factor).map_err(|error| LoadError::Parameter { factor: at, error })?;
        if !self.is_extended {
            let (below, value, is_clear) = at_rest(&system, T::zero());
            if !value.mantissa().size().is_finite() {
                return Err(SearchError::NotANumber { x: at, y: 0.0 }.into());
            }
            if is_clear || !T::HAS_EXTENDED {
                return Ok(Some(Sample { factor, below, value }));
            }
        }
        let zero = <T::Extended as Frequency<T>>::from_parameter(T::zero());
        let (below, value, _) = at_rest(&system, zero);
        let mantissa = T::from_f64(value.mantissa().to_f64());
        let value = Scaled::new(mantissa, value.exponent());
        Ok((!mantissa.is_zero()).then_some(Sample { factor, below, value }))
    }

    /// The single root of a bracket, confirmed in extended precision where there is one.
    fn certified<Y>(&mut self, lower: Sample<T>, upper: Sample<T>) -> Result<CriticalLoad<T>, LoadError>
    where
        Y: AtRest + System<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let root = self.polished(lower, upper)?;
        if !T::HAS_EXTENDED || self.is_extended {
            return Ok(root);
        }
        self.is_extended = true;
        let counts = [self.sample(root.lower)?.below, self.sample(root.upper)?.below];
        let root = if counts == [lower.below, upper.below] { Ok(root) } else { self.polished(lower, upper) };
        self.is_extended = false;
        root
    }

    /// The single root of a bracket by the secant method inside of counts.
    fn polished<Y>(&mut self, mut lower: Sample<T>, mut upper: Sample<T>) -> Result<CriticalLoad<T>, LoadError>
    where
        Y: AtRest + System<Parameter = T>,
        F: FnMut(T) -> Result<Y, ParameterError>,
    {
        let counts = [lower.below, upper.below];
        let half = T::from_f64(0.5);
        let (mut before, mut last) = (lower, upper);
        let (mut width, mut patience) = (upper.factor - lower.factor, PATIENCE);
        while upper.factor - lower.factor > self.room(upper.factor) {
            let secant = secant(&before, &last);
            let is_inside = secant > lower.factor && secant < upper.factor;
            patience = patience.saturating_sub(1);
            let point =
                if is_inside && patience > 0 { secant } else { lower.factor + (upper.factor - lower.factor) * half };
            let sample = self.sample(point)?;
            if sample.below <= counts[0] {
                lower = sample
            } else {
                upper = sample
            }
            if (upper.factor - lower.factor) * T::from_f64(2.0) <= width || patience == 0 {
                (width, patience) = (upper.factor - lower.factor, PATIENCE);
            }
            let is_close = (sample.factor - last.factor).abs() <= self.room(point) * half;
            (before, last) = (last, sample);
            if is_close {
                let room = self.room(point);
                let [below, above] = [self.sample(point - room)?, self.sample(point + room)?];
                if [below.below, above.below] == counts {
                    let [lower, upper] = [below.factor, above.factor];
                    return Ok(CriticalLoad { factor: point, lower, upper, multiplicity: counts[1] - counts[0] });
                }
            }
        }
        Ok(self.settled(&lower, &upper))
    }

    /// The roots of a bracket that is as narrow as an interval.
    fn settled(&self, lower: &Sample<T>, upper: &Sample<T>) -> CriticalLoad<T> {
        let factor = lower.factor + (upper.factor - lower.factor) * T::from_f64(0.5);
        let room = self.room(factor);
        let multiplicity = upper.below - lower.below;
        CriticalLoad { factor, lower: lower.factor - room, upper: upper.factor + room, multiplicity }
    }
}

/// The number of motions that begin to grow between two factors.
fn grown<T: Real>(lower: &Sample<T>, upper: &Sample<T>) -> Result<u64, LoadError> {
    upper.below.checked_sub(lower.below).ok_or(LoadError::Falls { factor: lower.factor.to_f64() })
}

/// The zero of the chord through two samples.
fn secant<T: Real>(before: &Sample<T>, last: &Sample<T>) -> T {
    let (a, b) = (before.value.over_power(last.value.exponent()), last.value.mantissa());
    last.factor - b * (last.factor - before.factor) / (b - a)
}

/// Count and Δ at rest, and whether no sum cancelled.
fn at_rest<S: Single, Y: Characteristic<S> + ?Sized>(system: &Y, zero: S) -> (u64, Scaled<S>, bool) {
    let (count, value) = counted_pass(system, zero, WittrickWilliams::<f64>::default());
    (count.below(), value, !(count.cancelled().any() || value.mantissa().is_zero()))
}

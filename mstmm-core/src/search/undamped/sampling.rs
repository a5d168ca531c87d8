//! Samples of a search: counts, Δ and its slope at frequencies. Nobody trusts them: what they propose is proven, or is no more than an estimate.

use crate::model::{FrequencyEstimates, SearchError};
use crate::number::{Dual, Real, Scalar, Scaled};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::search::undamped::found::NaturalFrequency;
use crate::subspace::WittrickWilliams;

/// Half the relative width of the interval of an estimate, in units of eps: room for the roundings of z = βl (about four, doubled in ω) and
/// of the planes.
const HALF_WIDTH: f64 = 16.0;

/// Binary exponent of the factor between the lowest estimate of a frequency and the frequency just above zero.
pub(super) const ZERO_EXPONENT: i32 = 30;

/// A frequency with its count and Δ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<T> {
    pub(super) omega: T,
    pub(super) below: u64,
    pub(super) value: Scaled<T>,
}

impl<T: Real> Default for Sample<T> {
    #[inline]
    fn default() -> Self {
        Sample { omega: T::zero(), below: 0, value: Scaled::new(T::one(), 0) }
    }
}

/// A frequency with its count, Δ and dΔ/dω; the power of two multiplies both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope<T> {
    pub(super) omega: T,
    pub(super) below: u64,
    pub(super) value: T,
    pub(super) derivative: T,
    pub(super) exponent: i64,
}

impl<T: Real> From<Slope<T>> for Sample<T> {
    #[inline]
    fn from(slope: Slope<T>) -> Self {
        Sample { omega: slope.omega, below: slope.below, value: Scaled::new(slope.value, slope.exponent) }
    }
}

/// A search in progress.
pub(super) struct Isolation<'a, Y: System + ?Sized, T: Real> {
    pub(super) system: &'a Y,
    pub(super) estimates: FrequencyEstimates,
    /// Frequency just above zero, below every root but those that are zero.
    pub(super) just_above_zero: T,
    /// Relative half width of the interval of an estimate.
    pub(super) half_width: T,
    /// The unit in the last place of the parameters, to which results are good.
    pub(super) precision: f64,
    pub(super) evaluations: usize,
    /// Splits in a row that left all roots of a bracket on one side.
    pub(super) idle_splits: u32,
}

impl<'a, T, Y> Isolation<'a, Y, T>
where
    T: Real,
    Y: System<Parameter = T> + Characteristic<T> + Characteristic<Dual<T>> + ?Sized,
{
    /// A search to the precision of the system's parameters.
    #[inline]
    pub(super) fn new(system: &'a Y) -> Self {
        let precision = <T as Scalar>::EPSILON;
        let estimates = system.frequency_estimates();
        let just_above_zero = T::one().times_power_of_two(estimates.least_exponent() - ZERO_EXPONENT);
        let half_width = T::from_f64(HALF_WIDTH * precision);
        Isolation { system, estimates, just_above_zero, half_width, precision, evaluations: 0, idle_splits: 0 }
    }

    /// Count and Δ at a frequency.
    #[inline]
    pub(super) fn sample(&mut self, omega: T) -> Result<Sample<T>, SearchError> {
        self.evaluations += 1;
        let (count, value) = counted_pass(self.system, omega, WittrickWilliams::<f64>::default());
        if !value.mantissa().size().is_finite() {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        Ok(Sample { omega, below: count.below(), value })
    }

    /// Count, Δ and its derivative at a frequency.
    #[inline]
    pub(super) fn slope(&mut self, omega: T) -> Result<Slope<T>, SearchError> {
        self.evaluations += 2;
        let (count, dual) = counted_pass(self.system, Dual::variable(omega), WittrickWilliams::<f64>::default());
        let Dual { value, derivative } = dual.mantissa();
        if !(value.size().is_finite() && derivative.size().is_finite()) {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        Ok(Slope { omega, below: count.below(), value, derivative, exponent: dual.exponent() })
    }

    /// Whether a bracket is no wider than the interval of an estimate.
    #[inline]
    pub(super) fn is_narrow(&self, lower: &Sample<T>, upper: &Sample<T>) -> bool {
        let half_width = self.half_width;
        upper.omega - lower.omega <= (half_width + half_width) * upper.omega
    }

    /// The estimate of some roots.
    #[inline]
    pub(super) fn estimate(&self, omega: T, multiplicity: u64) -> NaturalFrequency<T> {
        let away = omega * self.half_width;
        let (lower, upper) = (omega - away, omega + away);
        NaturalFrequency { omega, lower, upper, multiplicity, index: 0, is_proven: false }
    }
}

/// The middle of a bracket in the square root of the frequency, in which the frequencies of beams are evenly spaced.
#[inline]
pub(super) fn middle<T: Real>(lower: T, upper: T) -> T {
    if upper < lower + lower {
        return lower + (upper - lower) * T::from_f64(0.5);
    }
    let root = (lower.sqrt() + upper.sqrt()) * T::from_f64(0.5);
    root * root
}

//! Samples of a search: counts, Δ and its slope at frequencies, and whether they are doubtful.

use crate::model::{FrequencyEstimates, SearchError};
use crate::number::{
    Dual, Frequency, NEARLY_ZERO_EXPONENT, Real, Scalar, Scaled, Single, UNPROVEN_WIDTH, is_last, refuses_doubt,
};
use crate::pass::characteristic::{Characteristic, System, count_and_value, counted_pass};
use crate::search::identity::check_identity;
use crate::search::undamped::found::NaturalFrequency;
use crate::subspace::{Cancelled, WittrickWilliams};

/// Half the relative width of a certified interval, in units of eps: room for the roundings of z = βl (about four,
/// doubled in ω) and of the planes.
const HALF_WIDTH: f64 = 16.0;

/// Number of equal beams in a row whose common rounding adds up to one more such width.
const BEAMS_PER_WIDTH: f64 = 64.0;

/// Binary exponent of the factor between the lowest estimate of a frequency and the frequency just above zero.
pub(super) const ZERO_EXPONENT: i32 = 30;

/// Frequency below which `ω² m` underflows.
const LEAST: f64 = 1e-130;

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
    /// Frequency below which a root may be a zero that rounding has moved.
    pub(super) nearly_zero: T,
    /// Frequency just above zero, below every root but those that are zero.
    pub(super) just_above_zero: T,
    /// Relative half width of a certified interval.
    pub(super) half_width: T,
    /// The unit in the last place of the parameters, to which results are good.
    pub(super) precision: f64,
    pub(super) evaluations: usize,
    /// How many of these were in further precision than this.
    pub(super) extended: usize,
    /// Whether the result is doubtful: counts do not grow, slopes do not fit, or roots coincide.
    pub(super) is_doubtful: bool,
    /// Whether the certificate of a root was left to extended precision, so that those of others are left to it at once.
    pub(super) fronts_doubt: bool,
    /// Whether Δ of a sample was smaller, compared with its terms, than near a well-conditioned root.
    is_ill_conditioned: bool,
    /// Whether samples are taken beside a root.
    pub(super) is_at_root: bool,
    /// Splits in a row that left all roots of a bracket on one side.
    pub(super) idle_splits: u32,
}

impl<'a, T, Y> Isolation<'a, Y, T>
where
    T: Real,
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + ?Sized,
{
    /// A search in arithmetic of type `T`, to the precision of the system's parameters.
    #[inline]
    pub(super) fn new(system: &'a Y) -> Self {
        let precision = <Y::Parameter as Scalar>::EPSILON;
        let estimates = system.estimates();
        let power = |exponent| T::one().times_power_of_two(exponent);
        let waves = f64::from(estimates.wave_count());
        let half_width = T::from_f64(HALF_WIDTH * precision * (1.0 + waves / BEAMS_PER_WIDTH));
        Isolation {
            system,
            nearly_zero: power(estimates.lowest_exponent() - NEARLY_ZERO_EXPONENT),
            just_above_zero: power(estimates.least_exponent() - ZERO_EXPONENT),
            estimates,
            half_width,
            precision,
            fronts_doubt: false,
            evaluations: 0,
            extended: 0,
            is_doubtful: false,
            is_ill_conditioned: false,
            is_at_root: false,
            idle_splits: 0,
        }
    }

    /// Count and Δ at a frequency.
    #[inline]
    pub(super) fn sample(&mut self, omega: T) -> Result<Sample<T>, SearchError> {
        let (below, value) = self.count(omega, omega)?;
        Ok(Sample { omega, below, value })
    }

    /// The sample at the end of a range, which no certificate of a root confirms: fronts know what rounding has done to them where they are
    /// looked at as beside a root.
    pub(super) fn sample_end(&mut self, omega: T) -> Result<Sample<T>, SearchError> {
        self.is_at_root = Y::IS_NETWORK && T::HAS_EXTENDED;
        let sample = self.sample(omega)?;
        self.is_doubtful |= self.is_at_root && core::mem::take(&mut self.is_ill_conditioned);
        self.is_at_root = false;
        Ok(sample)
    }

    /// Count and Δ at a frequency of any type, of the size of ω.
    #[inline]
    pub(super) fn count<S: Single>(&mut self, x: S, omega: T) -> Result<(u64, Scaled<S>), SearchError>
    where
        Y: Characteristic<S>,
    {
        self.evaluations += 1;
        let (count, value) = counted_pass(self.system, x, WittrickWilliams::<f64>::new(self.is_at_root));
        if !value.mantissa().size().is_finite() {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        if value.mantissa().is_zero() {
            self.look_for_zeros(omega)?;
        }
        self.look_at(count.cancelled(), omega)?;
        Ok((count.below(), value))
    }

    /// The samples on both sides of a root.
    #[inline]
    pub(super) fn both_sides(&mut self, omega: T, away: T) -> Result<(Sample<T>, Sample<T>), SearchError> {
        (self.is_at_root, self.is_ill_conditioned) = (true, false);
        let samples = (self.sample(omega - away)?, self.sample(omega + away)?);
        self.is_at_root = false;
        Ok(samples)
    }

    /// Marks a pass in which sums cancelled as doubtful; refuses it where no further precision is left.
    #[inline]
    fn look_at(&mut self, cancelled: Cancelled, omega: T) -> Result<(), SearchError> {
        self.is_doubtful |= cancelled.any();
        self.is_ill_conditioned |= cancelled.at_root;
        if cancelled.partly && is_last::<T, Y::Parameter>() {
            return Err(SearchError::Unresolved { near: omega.to_f64() });
        }
        Ok(())
    }

    /// Whether extended precision confirms the counts at both ends of an interval, if Δ was small compared with its terms there.
    /// Where there is none, the interval is widened.
    #[inline]
    pub(super) fn is_proven(&mut self, root: &mut NaturalFrequency<T>, counts: (u64, u64)) -> bool {
        if !core::mem::take(&mut self.is_ill_conditioned) {
            return true;
        }
        if refuses_doubt::<T>() {
            let room = root.omega * self.half_width * T::from_f64(UNPROVEN_WIDTH);
            (root.lower, root.upper) = (root.omega - room, root.omega + room);
        }
        if !T::HAS_EXTENDED {
            return true;
        }
        self.fronts_doubt = true;
        (self.evaluations, self.extended) = (self.evaluations + 2, self.extended + 2);
        let ends = [root.lower, root.upper];
        let [below, above] = match self.system.precise_counts(ends.map(T::to_f64)) {
            [Some(lower), Some(upper)] => [lower.below, upper.below],
            _ => ends.map(|omega| extended(self.system, omega).0.below()),
        };
        (below, above) == counts
    }

    /// Refuses a system whose Δ vanishes at one frequency and at others far from it.
    #[cold]
    fn look_for_zeros(&mut self, omega: T) -> Result<(), SearchError> {
        if omega.size() < LEAST {
            return Err(SearchError::Unresolved { near: omega.to_f64() });
        }
        self.is_doubtful = true;
        check_identity(omega, |x| {
            self.evaluations += 1;
            // a soft inertia beside stiff springs may be lost to rounding at each of them
            let (count, value) = extended(self.system, x);
            (value.mantissa().size() == 0.0, count.vanished())
        })
    }

    /// Count, Δ and its derivative at a frequency.
    #[inline]
    pub(super) fn slope(&mut self, omega: T) -> Result<Slope<T>, SearchError> {
        self.evaluations += 2;
        // what cancels here does so in other samples of the search
        let (count, dual) = count_and_value::<false, _, _>(self.system, Dual::variable(omega));
        let Dual { value, derivative } = dual.mantissa();
        if !(value.size().is_finite() && derivative.size().is_finite()) {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        Ok(Slope { omega, below: count.below(), value, derivative, exponent: dual.exponent() })
    }

    /// Whether a bracket is no wider than a certified interval.
    #[inline]
    pub(super) fn is_narrow(&self, lower: &Sample<T>, upper: &Sample<T>) -> bool {
        let half_width = self.half_width;
        upper.omega - lower.omega <= (half_width + half_width) * upper.omega
    }

    /// The certified entry of the roots in a narrow bracket.
    #[inline]
    pub(super) fn settle(&mut self, lower: Sample<T>, upper: Sample<T>) -> Result<NaturalFrequency<T>, SearchError> {
        let omega = lower.omega + (upper.omega - lower.omega) * T::from_f64(0.5);
        let margin = omega * self.half_width;
        let (below, above) = self.both_sides(omega, margin)?;
        // where rounding blurs the counts, the interval includes the samples that were seen to enclose the roots
        let start = if below.below == lower.below || below.omega < lower.omega { below } else { lower };
        let end = if above.below == upper.below || above.omega > upper.omega { above } else { upper };
        let multiplicity = upper.below - lower.below;
        let mut root = NaturalFrequency { omega, lower: start.omega, upper: end.omega, multiplicity };
        // at a root passes look closer: counts that differ there from those of the search were rounding
        self.is_doubtful |= (below.below, above.below) != (lower.below, upper.below);
        self.is_doubtful |= !self.is_proven(&mut root, (lower.below, upper.below));
        Ok(root)
    }
}

/// The count and Δ in extended precision; not inlined, since they are seldom needed.
#[cold]
#[inline(never)]
pub(super) fn extended<T: Real, Y: Characteristic<T::Extended> + ?Sized>(
    system: &Y,
    omega: T,
) -> (WittrickWilliams<f64>, Scaled<T::Extended>) {
    let exactly = <T::Extended as Frequency<T>>::from_parameter(omega);
    count_and_value::<true, _, _>(system, exactly)
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

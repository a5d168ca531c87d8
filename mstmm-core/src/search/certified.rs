//! Isolation of roots by counts: brackets that hold a known number of roots, split until each is settled.

use super::natural::{FrequencyList, NaturalFrequency};
use super::polish::Slope;
use crate::bounds::FrequencyBounds;
use crate::characteristic::{Characteristic, System, count_and_value, tallied};
use crate::count::{Cancelled, Count};
use crate::doubt::{NEARLY_ZERO_EXPONENT, TOUCHING, UNJUDGED, check_identity, is_last, is_unjudged};
use crate::error::SearchError;
use crate::list::List;
use crate::scalar::{Dual, Frequency, Real, Scalar};
use crate::scaled::Scaled;

/// Half the relative width of a certified interval, in units of eps: room for the roundings of z = βl (about four,
/// doubled in ω) and of the planes.
const HALF_WIDTH: f64 = 16.0;

/// The same rounding in each of so many equal beams in a row adds up to one more such width.
const BEAMS_PER_WIDTH: f64 = 64.0;

/// Upper ends of brackets that wait: each split adds one, and a bracket is halved at most about 64 times.
const WAITING: usize = 128;

/// Factor between the lowest estimate of a frequency and what is taken to be just above zero.
const ZERO_EXPONENT: i32 = 30;

/// Below it the square of a frequency, with the masses that it multiplies, vanishes in the arithmetic.
const LEAST: f64 = 1e-130;

/// After so many splits in a row that separate nothing, roots are taken for a cluster, which halving would reach too slowly.
const CLUSTER: u32 = 2;

/// A frequency with its count and Δ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample<T> {
    pub(super) omega: T,
    pub(super) below: u64,
    pub(super) value: Scaled<T>,
}

impl<T: Real> Default for Sample<T> {
    fn default() -> Self {
        Sample { omega: T::zero(), below: 0, value: Scaled::new(T::one(), 0) }
    }
}

/// A search in progress.
pub(super) struct Isolation<'a, Y: System + ?Sized, T: Real> {
    system: &'a Y,
    bounds: FrequencyBounds,
    /// A frequency below which rounding may have made one of a zero.
    nearly_zero: T,
    /// Just above zero: below every frequency but those that are zero.
    just_above_zero: T,
    /// Relative half width of a certified interval.
    pub(super) half_width: T,
    /// The unit in the last place that results are good to.
    pub(super) precision: f64,
    evaluations: usize,
    /// Whether something looked like rounding: counts that do not grow, slopes that do not fit, roots that coincide.
    pub(super) is_doubtful: bool,
    /// Whether Δ of a sample was less beside its terms than it is beside a well-conditioned root.
    is_ill_conditioned: bool,
    /// Whether samples are taken beside a root.
    pub(super) is_at_root: bool,
    /// Splits in a row that left all roots of a bracket on one side.
    idle_splits: u32,
}

impl<'a, T, Y> Isolation<'a, Y, T>
where
    T: Real,
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Judge> + ?Sized,
{
    /// A search in arithmetic of type `T`, to the precision of the system's parameters.
    pub(super) fn new(system: &'a Y) -> Self {
        let precision = <Y::Parameter as Scalar>::EPSILON;
        let bounds = system.bounds();
        let power = |exponent| T::one().times_power_of_two(exponent);
        let waves = f64::from(bounds.wave_count());
        let half_width = T::from_f64(HALF_WIDTH * precision * (1.0 + waves / BEAMS_PER_WIDTH));
        Isolation {
            system,
            nearly_zero: power(bounds.lowest_exponent() - NEARLY_ZERO_EXPONENT),
            just_above_zero: power(bounds.least_exponent() - ZERO_EXPONENT),
            bounds,
            half_width,
            precision,
            evaluations: 0,
            is_doubtful: false,
            is_ill_conditioned: false,
            is_at_root: false,
            idle_splits: 0,
        }
    }

    /// Count and Δ at a frequency.
    pub(super) fn sample(&mut self, omega: T) -> Result<Sample<T>, SearchError> {
        self.evaluations += 1;
        let (count, value) = tallied(self.system, omega, Count::new(self.is_at_root));
        if !value.mantissa().size().is_finite() {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        self.look_at(count.cancelled(), omega)?;
        if value.mantissa().is_zero() {
            self.look_for_zeros(omega)?;
        }
        Ok(Sample { omega, below: count.below(), value })
    }

    /// The samples on both sides of a root.
    pub(super) fn both_sides(&mut self, omega: T, away: T) -> Result<(Sample<T>, Sample<T>), SearchError> {
        (self.is_at_root, self.is_ill_conditioned) = (true, false);
        let samples = (self.sample(omega - away)?, self.sample(omega + away)?);
        self.is_at_root = false;
        Ok(samples)
    }

    /// Doubts a pass in which sums cancelled. One that judges has no other to ask.
    fn look_at(&mut self, cancelled: Cancelled, omega: T) -> Result<(), SearchError> {
        self.is_doubtful |= cancelled.any();
        self.is_ill_conditioned |= cancelled.at_root;
        if cancelled.partly && is_last::<T, Y::Parameter>() {
            return Err(SearchError::Unresolved { near: omega.to_f64() });
        }
        Ok(())
    }

    /// Whether the counts at both ends of an interval are what they should be by the arithmetic that judges, if Δ was small beside
    /// its terms there. Where nothing judges, the interval is widened.
    pub(super) fn is_proven(&mut self, root: &mut NaturalFrequency<T>, counts: (u64, u64)) -> bool {
        if !core::mem::take(&mut self.is_ill_conditioned) {
            return true;
        }
        if is_unjudged::<T>() {
            let room = root.omega * self.half_width * T::from_f64(UNJUDGED);
            (root.lower, root.upper) = (root.omega - room, root.omega + room);
        }
        if !T::HAS_JUDGE {
            return true;
        }
        self.evaluations += 2;
        let [below, above] = [root.lower, root.upper].map(|omega| judged_below(self.system, omega));
        (below, above) == counts
    }

    /// Gives up where Δ vanishes at one frequency, and at others far from it.
    #[cold]
    fn look_for_zeros(&mut self, omega: T) -> Result<(), SearchError> {
        if omega.size() < LEAST {
            return Err(SearchError::Unresolved { near: omega.to_f64() });
        }
        check_identity(omega, |x| {
            self.evaluations += 1;
            // counted like all samples, which are one piece of code then
            count_and_value::<true, _, _>(self.system, x).1.mantissa().is_zero()
        })
    }

    /// Count, Δ and its derivative at a frequency.
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

    /// All frequencies of a range.
    pub(super) fn in_range<const CAP: usize>(
        &mut self,
        start: T,
        end: T,
    ) -> Result<FrequencyList<T, CAP>, SearchError> {
        let valid = start >= T::zero() && start < end && end.size().is_finite();
        if !valid {
            return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() });
        }
        let mut found = List::new();
        let zero = self.just_above_zero;
        let margin = self.half_width + self.half_width;
        let first = if start > zero { start - start * margin } else { zero };
        let mut lower = self.sample(first)?;
        if start.is_zero() {
            Self::push(&mut found, Self::rigid_body_modes(&lower))?;
        }
        let mut waiting = List::<Sample<T>, WAITING>::new();
        if end > lower.omega {
            Self::wait(&mut waiting, self.sample(end + end * margin)?)?;
        }
        while let Some(root) = self.next(&mut lower, &mut waiting)? {
            self.doubt(&root, found.last());
            if root.upper >= start && root.lower <= end {
                Self::push(&mut found, Some(root))?;
            }
        }
        Ok(FrequencyList { frequencies: found, evaluations: self.evaluations })
    }

    /// The lowest frequencies.
    pub(super) fn first<const N: usize>(&mut self) -> Result<FrequencyList<T, N>, SearchError> {
        let wanted = N as u64;
        let bounds = self.bounds;
        let mut found = List::new();
        let mut lower = self.sample(self.just_above_zero)?;
        Self::push(&mut found, Self::rigid_body_modes(&lower))?;
        let mut settled = lower.below;
        // upper ends in ascending order first, to be turned round
        let mut waiting = List::<Sample<T>, WAITING>::new();
        let mut exponent = bounds.lowest_exponent() + 1;
        let mut highest = lower;
        while highest.below < wanted {
            if !bounds.is_continuous() && exponent > bounds.highest_exponent() + ZERO_EXPONENT {
                return Err(SearchError::TooFewRoots { found: highest.below });
            }
            highest = self.sample(T::one().times_power_of_two(exponent))?;
            Self::wait(&mut waiting, highest)?;
            exponent += 2;
        }
        waiting.reverse();
        while settled < wanted {
            let Some(root) = self.next(&mut lower, &mut waiting)? else { break };
            self.doubt(&root, found.last());
            settled += root.multiplicity;
            Self::push(&mut found, Some(root))?;
        }
        Ok(FrequencyList { frequencies: found, evaluations: self.evaluations })
    }

    /// Doubts what rounding makes of roots that coincide: several in one interval, two that nearly touch, one that is
    /// nearly zero.
    fn doubt(&mut self, root: &NaturalFrequency<T>, last: Option<&NaturalFrequency<T>>) {
        let touching = last.is_some_and(|last| root.lower - last.upper <= root.omega * T::from_f64(TOUCHING));
        self.is_doubtful |= root.multiplicity > 1 || touching || root.omega < self.nearly_zero;
    }

    /// The entry of frequencies that are zero, if there are any.
    fn rigid_body_modes(just_above_zero: &Sample<T>) -> Option<NaturalFrequency<T>> {
        let (zero, upper) = (T::zero(), just_above_zero.omega);
        let multiplicity = just_above_zero.below;
        (multiplicity > 0).then_some(NaturalFrequency { omega: zero, lower: zero, upper, multiplicity })
    }

    fn push<const CAP: usize>(
        found: &mut List<NaturalFrequency<T>, CAP>,
        root: Option<NaturalFrequency<T>>,
    ) -> Result<(), SearchError> {
        let Some(root) = root else { return Ok(()) };
        // intervals that overlap hold their roots together
        if let Some(last) = found.as_mut_slice().last_mut()
            && last.upper > root.lower
            && !last.omega.is_zero()
        {
            last.omega = (last.lower + root.upper) * T::from_f64(0.5);
            (last.upper, last.multiplicity) = (root.upper, last.multiplicity + root.multiplicity);
            return Ok(());
        }
        found.push(root).map_err(|_| SearchError::Capacity { capacity: CAP })
    }

    fn wait(waiting: &mut List<Sample<T>, WAITING>, sample: Sample<T>) -> Result<(), SearchError> {
        waiting.push(sample).map_err(|lost| SearchError::Unresolved { near: lost.omega.to_f64() })
    }

    /// The lowest root above `lower`, or several that cannot be told apart; `lower` moves beyond it.
    ///
    /// The bracket is from `lower` to the last of the upper ends that wait, which is the lowest of them.
    fn next(
        &mut self,
        lower: &mut Sample<T>,
        waiting: &mut List<Sample<T>, WAITING>,
    ) -> Result<Option<NaturalFrequency<T>>, SearchError> {
        while let Some(&upper) = waiting.last() {
            let roots = upper.below.saturating_sub(lower.below);
            let settled = match roots {
                0 => None,
                1 => Some(self.polish(*lower, upper)?),
                _ if self.is_narrow(lower, &upper) => Some(self.settle(*lower, upper)?),
                _ => {
                    let middle = self.split(lower, &upper, roots)?;
                    Self::wait(waiting, middle)?;
                    continue;
                }
            };
            waiting.pop();
            *lower = upper;
            if settled.is_some() {
                return Ok(settled);
            }
        }
        Ok(None)
    }

    /// Whether a bracket is no wider than a certified interval.
    pub(super) fn is_narrow(&self, lower: &Sample<T>, upper: &Sample<T>) -> bool {
        let half_width = self.half_width;
        upper.omega - lower.omega <= (half_width + half_width) * upper.omega
    }

    /// The certified entry of the roots in a narrow bracket.
    pub(super) fn settle(&mut self, lower: Sample<T>, upper: Sample<T>) -> Result<NaturalFrequency<T>, SearchError> {
        let omega = lower.omega + (upper.omega - lower.omega) * T::from_f64(0.5);
        let margin = omega * self.half_width;
        let (below, above) = (self.sample(omega - margin)?, self.sample(omega + margin)?);
        // where rounding blurs the counts, the interval takes in all that was seen to hold them
        let start = if below.below == lower.below || below.omega < lower.omega { below } else { lower };
        let end = if above.below == upper.below || above.omega > upper.omega { above } else { upper };
        let multiplicity = upper.below - lower.below;
        Ok(NaturalFrequency { omega, lower: start.omega, upper: end.omega, multiplicity })
    }

    /// A sample inside a bracket of several roots, with a count between those of its ends.
    fn split(&mut self, lower: &Sample<T>, upper: &Sample<T>, roots: u64) -> Result<Sample<T>, SearchError> {
        let middle = middle(lower.omega, upper.omega);
        let close = (upper.omega - lower.omega) * T::from_f64(16.0) < upper.omega;
        let is_cluster = close && self.idle_splits >= CLUSTER;
        let mut sample =
            if is_cluster { self.split_cluster(lower, upper, middle, roots)? } else { self.sample(middle)? };
        let below = sample.below.clamp(lower.below, upper.below);
        self.is_doubtful |= below != sample.below;
        sample.below = below;
        self.idle_splits = if below == lower.below || below == upper.below { self.idle_splits + 1 } else { 0 };
        Ok(sample)
    }

    /// A sample beside a cluster of roots, found by Newton's method for a root of that multiplicity.
    fn split_cluster(
        &mut self,
        lower: &Sample<T>,
        upper: &Sample<T>,
        middle: T,
        roots: u64,
    ) -> Result<Sample<T>, SearchError> {
        let slope = self.slope(middle)?;
        let step = slope.value / slope.derivative * T::from_f64(roots as f64);
        let width = upper.omega - lower.omega;
        // beside the estimate, on the side that cuts most off the bracket
        let beside = step.abs() * T::from_f64(0.125) + middle * self.half_width;
        let target = middle - step + if step > T::zero() { beside } else { -beside };
        let useful = target > lower.omega && target < upper.omega && step.abs() < width * T::from_f64(0.25);
        if !useful || target == middle {
            return Ok(slope.into());
        }
        self.sample(target)
    }
}

/// The count by the arithmetic that judges; a call, since it is seldom asked.
#[cold]
#[inline(never)]
fn judged_below<T: Real, Y: Characteristic<T::Judge> + ?Sized>(system: &Y, omega: T) -> u64 {
    let exactly = <T::Judge as Frequency<T>>::from_parameter(omega);
    count_and_value::<true, _, _>(system, exactly).0.below()
}

/// The middle of a bracket, in the square root of the frequency: there the frequencies of beams are evenly spaced.
pub(super) fn middle<T: Real>(lower: T, upper: T) -> T {
    if upper < lower + lower {
        return lower + (upper - lower) * T::from_f64(0.5);
    }
    let root = (lower.sqrt() + upper.sqrt()) * T::from_f64(0.5);
    root * root
}

//! Isolation of roots by counts: brackets that hold a known number of roots, split until each is settled.

use crate::model::SearchError;
use crate::number::{Dual, List, Real, Store};
use crate::pass::characteristic::{Characteristic, System};
use crate::search::room::add;
use crate::search::undamped::found::{Found, NaturalFrequency};
use crate::search::undamped::sampling::{Isolation, Sample, ZERO_EXPONENT, middle};

/// Upper ends of brackets that wait: each split adds one, and a bracket is halved at most about 64 times.
const WAITING: usize = 128;

/// Number of splits in a row that separate nothing after which roots count as a cluster, which halving would reach too slowly.
const CLUSTER: u32 = 2;

impl<'a, T, Y> Isolation<'a, Y, T>
where
    T: Real,
    Y: System<Parameter = T> + Characteristic<T> + Characteristic<Dual<T>> + ?Sized,
{
    /// Estimates of all frequencies of a range.
    #[inline]
    pub(super) fn in_range<L: Store<NaturalFrequency<T>>>(
        &mut self,
        start: T,
        end: T,
    ) -> Result<Found<L>, SearchError> {
        let [first, last] = self.enclosing(start, end);
        let mut found = L::empty();
        let mut lower = self.sample(first)?;
        if start.is_zero() {
            self.push(&mut found, self.at_rest(lower.below))?;
        }
        let mut waiting = List::<Sample<T>, WAITING>::new();
        if end > lower.omega {
            Self::wait(&mut waiting, self.sample(last)?)?;
        }
        while let Some(root) = self.next(&mut lower, &mut waiting)? {
            self.push(&mut found, Some(root))?;
        }
        Ok(Found { frequencies: found, evaluations: self.evaluations, runs: [0; 2] })
    }

    /// Estimates of the lowest frequencies: entries whose multiplicities add up to so many, or to all that there are.
    #[inline]
    pub(super) fn first<L: Store<NaturalFrequency<T>>>(&mut self, wanted: u64) -> Result<Found<L>, SearchError> {
        let estimates = self.estimates;
        let mut found = L::empty();
        let mut lower = self.sample(self.just_above_zero)?;
        self.push(&mut found, self.at_rest(lower.below))?;
        let mut settled = lower.below;
        // upper ends in ascending order first, to be turned round
        let mut waiting = List::<Sample<T>, WAITING>::new();
        let mut exponent = estimates.lowest_exponent() + 1;
        let mut highest = lower;
        while highest.below < wanted {
            if !estimates.is_continuous() && exponent > estimates.highest_exponent() + ZERO_EXPONENT {
                break;
            }
            highest = self.sample(T::one().times_power_of_two(exponent))?;
            Self::wait(&mut waiting, highest)?;
            exponent += 2;
        }
        waiting.reverse();
        while settled < wanted {
            let Some(root) = self.next(&mut lower, &mut waiting)? else { break };
            settled += root.multiplicity;
            self.push(&mut found, Some(root))?;
        }
        Ok(Found { frequencies: found, evaluations: self.evaluations, runs: [0; 2] })
    }

    /// The frequencies beside a range between which the frequencies that meet it lie.
    #[inline]
    pub(super) fn enclosing(&self, start: T, end: T) -> [T; 2] {
        let (zero, margin) = (self.just_above_zero, self.half_width + self.half_width);
        [if start > zero { start - start * margin } else { zero }, end + end * margin]
    }

    /// The entry of so many frequencies at rest, if there are any.
    #[inline]
    pub(super) fn at_rest(&self, multiplicity: u64) -> Option<NaturalFrequency<T>> {
        let (zero, upper) = (T::zero(), self.just_above_zero);
        let rest = NaturalFrequency { omega: zero, lower: zero, upper, multiplicity, index: 1, is_proven: false };
        (multiplicity > 0).then_some(rest)
    }

    /// Adds a root, if there is one, with its index.
    #[inline]
    pub(super) fn push<L: Store<NaturalFrequency<T>>>(
        &self,
        found: &mut L,
        root: Option<NaturalFrequency<T>>,
    ) -> Result<(), SearchError> {
        let Some(root) = root else { return Ok(()) };
        let index = found.last().map_or(1, |last| last.index + last.multiplicity);
        add(found, NaturalFrequency { index, ..root })
    }

    #[inline]
    fn wait(waiting: &mut List<Sample<T>, WAITING>, sample: Sample<T>) -> Result<(), SearchError> {
        waiting.push(sample).map_err(|lost| SearchError::Unresolved { near: lost.omega.to_f64() })
    }

    /// The lowest root above `lower`, or several that cannot be told apart; `lower` moves beyond it.
    ///
    /// The bracket is from `lower` to the last of the upper ends that wait, which is the lowest of them.
    #[inline]
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
                _ if self.is_narrow(lower, &upper) => Some(self.estimate(middle(lower.omega, upper.omega), roots)),
                _ => {
                    let middle = self.split(lower, &upper, roots)?;
                    if !(lower.omega < middle.omega && middle.omega < upper.omega) {
                        return Err(SearchError::Unresolved { near: upper.omega.to_f64() });
                    }
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

    /// A sample inside a bracket of several roots, with a count between those of its ends.
    #[inline]
    fn split(&mut self, lower: &Sample<T>, upper: &Sample<T>, roots: u64) -> Result<Sample<T>, SearchError> {
        let middle = middle(lower.omega, upper.omega);
        let close = (upper.omega - lower.omega) * T::from_f64(16.0) < upper.omega;
        let is_cluster = close && self.idle_splits >= CLUSTER;
        let mut sample =
            if is_cluster { self.split_cluster(lower, upper, middle, roots)? } else { self.sample(middle)? };
        let below = sample.below.clamp(lower.below, upper.below);
        sample.below = below;
        self.idle_splits = if below == lower.below || below == upper.below { self.idle_splits + 1 } else { 0 };
        Ok(sample)
    }

    /// A sample beside a cluster of roots, found by Newton's method for a root of that multiplicity.
    #[inline]
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

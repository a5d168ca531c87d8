//! Isolation of roots by counts: brackets that hold a known number of roots, split until each is settled.

use crate::model::SearchError;
use crate::number::{Dual, List, Real, Store, TOUCHING};
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
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + ?Sized,
{
    /// All frequencies of a range.
    #[inline]
    pub(super) fn in_range<L: Store<NaturalFrequency<T>>>(
        &mut self,
        start: T,
        end: T,
    ) -> Result<Found<L>, SearchError> {
        let [first, last] = self.enclosing(start, end)?;
        let mut found = L::empty();
        let mut lower = self.sample_end(first)?;
        let bottom = lower;
        if start.is_zero() {
            Self::push(&mut found, self.rigid_body_modes(lower.below))?;
        }
        let mut waiting = List::<Sample<T>, WAITING>::new();
        if end > lower.omega {
            Self::wait(&mut waiting, self.sample_end(last)?)?;
        }
        while let Some(root) = self.next(&mut lower, &mut waiting)? {
            self.doubt(&root, found.last());
            if root.upper >= start && root.lower <= end {
                Self::push(&mut found, Some(root))?;
            }
        }
        self.complete(found.values(), &bottom, &lower)?;
        Ok(Found { frequencies: found, evaluations: self.evaluations, extended: self.extended })
    }

    /// The lowest frequencies: entries whose multiplicities add up to so many.
    #[inline]
    pub(super) fn first<L: Store<NaturalFrequency<T>>>(&mut self, wanted: u64) -> Result<Found<L>, SearchError> {
        let estimates = self.estimates;
        let mut found = L::empty();
        let mut lower = self.sample(self.just_above_zero)?;
        Self::push(&mut found, self.rigid_body_modes(lower.below))?;
        let (bottom, mut settled) = (lower, lower.below);
        // upper ends in ascending order first, to be turned round
        let mut waiting = List::<Sample<T>, WAITING>::new();
        let mut exponent = estimates.lowest_exponent() + 1;
        let mut highest = lower;
        while highest.below < wanted {
            if !estimates.is_continuous() && exponent > estimates.highest_exponent() + ZERO_EXPONENT {
                return Err(SearchError::TooFewRoots { found: highest.below, wanted });
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
        self.complete(found.values(), &bottom, &lower)?;
        Ok(Found { frequencies: found, evaluations: self.evaluations, extended: self.extended })
    }

    /// Counts the roots that intervals hold beyond the first and the last sample of a search, where a pair that rounding cannot tell
    /// apart was cut.
    #[inline]
    fn complete(
        &mut self,
        found: &mut [NaturalFrequency<T>],
        bottom: &Sample<T>,
        top: &Sample<T>,
    ) -> Result<(), SearchError> {
        let mut more = 0;
        // motions of rigid bodies have an entry of their own
        if let Some(first) = found.first_mut().filter(|root| !root.omega.is_zero())
            && first.lower < bottom.omega
        {
            more += bottom.below.saturating_sub(self.sample(first.lower)?.below);
            first.multiplicity += more;
        }
        if let Some(last) = found.last_mut().filter(|root| !root.omega.is_zero())
            && last.upper > top.omega
        {
            let beyond = self.sample(last.upper)?.below.saturating_sub(top.below);
            last.multiplicity += beyond;
            more += beyond;
        }
        self.is_doubtful |= more > 0;
        Ok(())
    }

    /// The frequencies beside a range between which the frequencies that meet it lie; an error for a range that is none.
    #[inline]
    pub(super) fn enclosing(&self, start: T, end: T) -> Result<[T; 2], SearchError> {
        let valid = start >= T::zero() && start < end && end.size().is_finite();
        if !valid {
            return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() });
        }
        let (zero, margin) = (self.just_above_zero, self.half_width + self.half_width);
        Ok([if start > zero { start - start * margin } else { zero }, end + end * margin])
    }

    /// Marks a root that rounding may have moved as doubtful.
    #[inline]
    fn doubt(&mut self, root: &NaturalFrequency<T>, last: Option<&NaturalFrequency<T>>) {
        self.is_doubtful |= self.may_have_moved(root, last);
    }

    /// Whether rounding may have moved a root: several are in one interval, two nearly touch, or it is nearly zero.
    #[inline]
    pub(super) fn may_have_moved(&self, root: &NaturalFrequency<T>, last: Option<&NaturalFrequency<T>>) -> bool {
        let touching = last.is_some_and(|last| root.lower - last.upper <= root.omega * T::from_f64(TOUCHING));
        root.multiplicity > 1 || touching || root.omega < self.nearly_zero
    }

    /// The entry of so many frequencies that are zero, if there are any.
    #[inline]
    pub(super) fn rigid_body_modes(&self, multiplicity: u64) -> Option<NaturalFrequency<T>> {
        let (zero, upper) = (T::zero(), self.just_above_zero);
        (multiplicity > 0).then_some(NaturalFrequency { omega: zero, lower: zero, upper, multiplicity })
    }

    /// Adds a root, if there is one.
    #[inline]
    pub(super) fn push<L: Store<NaturalFrequency<T>>>(
        found: &mut L,
        root: Option<NaturalFrequency<T>>,
    ) -> Result<(), SearchError> {
        let Some(root) = root else { return Ok(()) };
        // intervals that overlap hold their roots together
        if let Some(last) = found.values().last_mut()
            && last.upper > root.lower
            && !last.omega.is_zero()
        {
            last.omega = (last.lower + root.upper) * T::from_f64(0.5);
            (last.upper, last.multiplicity) = (root.upper, last.multiplicity + root.multiplicity);
            return Ok(());
        }
        add(found, root)
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

    /// A sample inside a bracket of several roots, with a count between those of its ends.
    #[inline]
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

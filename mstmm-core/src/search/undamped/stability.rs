//! Static stability: the count of motions that grow, whose ω² is below zero.

use crate::model::SearchError;
use crate::number::{Dual, Growth, Real, Scalar, Single, refuses_doubt};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::pass::searched::Undamped;
use crate::search::undamped::sampling::Isolation;
use crate::subspace::WittrickWilliams;
use num_traits::{One, Zero};

/// Binary exponent of the factor below the lowest estimate of a frequency within which roots on either side of rest are looked for: far
/// more than rounding moves one, while waves are still short.
const BESIDE_REST: i32 = 4;

/// Refuses a system with motions that grow.
#[inline]
pub(crate) fn check_stability<Y: Undamped + ?Sized>(system: &Y) -> Result<(), SearchError> {
    // estimates of all elements are taken for a system that may buckle alone
    if const { Y::MAY_BUCKLE } && system.may_buckle() {
        return Isolation::<Y, Y::Parameter>::new(system).check_stability();
    }
    Ok(())
}

/// The number of roots below a square of either sign, if Δ is finite and not zero there, and no sum cancelled.
#[inline]
fn clear_count<S: Single, Y: Characteristic<S> + ?Sized>(system: &Y, x: S) -> Option<u64> {
    let (count, delta) = counted_pass(system, x, WittrickWilliams::<f64>::default());
    let delta = delta.mantissa();
    let is_clear = delta.size().is_finite() && !delta.is_zero() && !count.cancelled().any();
    is_clear.then(|| count.below())
}

impl<Y: Undamped + ?Sized> Isolation<'_, Y, Y::Parameter> {
    /// Refuses a system with motions that grow.
    #[inline]
    pub(super) fn check_stability(&mut self) -> Result<(), SearchError> {
        if const { !Y::MAY_BUCKLE } {
            return Ok(());
        }
        match self.unstable_modes()? {
            0 => Ok(()),
            modes => Err(SearchError::Unstable { modes }),
        }
    }

    /// The number of motions that grow. Where the counts on both sides of rest agree it is that; else a root is near, as those of rigid
    /// bodies are, and extended precision counts just below zero.
    #[inline]
    pub(super) fn unstable_modes(&mut self) -> Result<u64, SearchError> {
        if const { !Y::MAY_BUCKLE } {
            return Ok(0);
        }
        if !self.system.may_buckle() {
            return Ok(0);
        }
        let beside = Y::Parameter::one().times_power_of_two(self.estimates.lowest_exponent() - BESIDE_REST);
        self.evaluations += 2;
        let (below, above) = (clear_count(self.system, Growth(beside)), clear_count(self.system, beside));
        match below {
            Some(count) if below == above => Ok(count),
            _ if Y::Parameter::HAS_EXTENDED => self.extended_unstable_modes(),
            _ => {
                let count = self.just_below_zero()?;
                let is_doubtful = refuses_doubt::<Y::Parameter>() && below != Some(count);
                if is_doubtful { Err(SearchError::Unresolved { near: 0.0 }) } else { Ok(count) }
            }
        }
    }

    /// The number of motions that grow, in extended precision.
    #[cold]
    #[inline(never)]
    fn extended_unstable_modes(&mut self) -> Result<u64, SearchError> {
        let mut judge = Isolation::<Y, <Y::Parameter as Real>::Extended>::new(self.system);
        let count = judge.just_below_zero()?;
        self.evaluations += judge.evaluations;
        self.extended += judge.evaluations;
        Ok(count)
    }
}

impl<T, Y> Isolation<'_, Y, T>
where
    T: Real,
    Y: System + Characteristic<T> + Characteristic<Dual<T>> + Characteristic<T::Extended> + Characteristic<Growth<T>>,
    Y: ?Sized,
{
    /// The count at the square `-ε²`, with ε below all frequencies but those that are zero.
    fn just_below_zero(&mut self) -> Result<u64, SearchError> {
        let (count, delta) = self.count(Growth(self.just_above_zero), self.just_above_zero)?;
        if delta.mantissa().is_zero() { Err(SearchError::Unresolved { near: 0.0 }) } else { Ok(count) }
    }
}

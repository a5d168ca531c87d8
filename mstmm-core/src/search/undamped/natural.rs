//! Natural frequencies of undamped systems: the trait that users call.

use crate::model::SearchError;
use crate::number::{Dual, Frequency, List, Parameter, Real, Scalar, Scaled, refuses_doubt};
use crate::pass::characteristic::{Characteristic, System, count_and_value};
use crate::search::undamped::found::{FrequencyList, NaturalFrequency};
use crate::search::undamped::sampling::Isolation;
use crate::search::undamped::searched::Undamped;
use crate::search::undamped::stability::check_stability;
use crate::search::undamped::together::Together;
use crate::subspace::WittrickWilliams;
use core::ops::RangeInclusive;
use num_traits::Zero;

/// The certified searches of undamped systems.
///
/// A system with motions that grow, as of a column that buckles, has no list of frequencies: its searches say
/// [`Unstable`](SearchError::Unstable). Frequencies at zero are those of rigid bodies and of what is just about to buckle.
///
/// A result that is doubtful (roots coincide or nearly do, slopes do not fit, sums cancel) is confirmed by counts in extended
/// precision, double-double for `f64`, or the search is made again there. Without the feature `judge` a doubtful result is refused.
///
/// A thread of 128 kB is enough, of 384 kB in debug builds.
pub trait NaturalFrequencies: System {
    /// Number of natural frequencies below `omega` [rad/s], with multiplicity; rigid-body modes count from ω > 0 on. It is 0 for
    /// `omega <= 0`.
    ///
    /// It takes two evaluations, a relative 4e-6 below and above `omega`. Where their counts differ, or sums cancel in one of them,
    /// the count is taken in extended precision, a relative 9e-16 below and above.
    ///
    /// # Errors
    /// [`SearchError::Unstable`] for a system with motions that grow; [`SearchError::Unresolved`] where extended precision fails, too, as
    /// at a frequency itself; [`SearchError::Zero`] for a model in
    /// which something is held twice; [`SearchError::NotANumber`] for a NaN, or an `omega` so large that numbers overflow.
    ///
    /// # Source
    /// Wittrick and Williams along the tree of transfer paths.
    #[inline]
    fn count_below(&self, omega: Self::Parameter) -> Result<u64, SearchError>
    where
        Self: Undamped,
    {
        if omega <= Self::Parameter::zero() {
            return Ok(0);
        }
        check_stability(self)?;
        match count_beside(self, omega)? {
            Some(below) => Ok(below),
            None if Self::Parameter::HAS_EXTENDED => extended_count(self, omega),
            None => Err(SearchError::Unresolved { near: omega.to_f64() }),
        }
    }

    /// Number of motions that grow: of modes with `ω² < 0`, as those of a column under more than its buckling load. Each has a pair of
    /// real eigenvalues ±λ, which [`eigenvalues`](crate::search::Eigenvalues::eigenvalues) finds.
    ///
    /// It is the count J at `ω² = -ε²`, with ε below all frequencies but those that are zero, so that J just above zero less this number
    /// is the number of modes at rest. No system is evaluated whose elements all have positive stiffness
    /// ([`Element::MAY_BUCKLE`](crate::element::Element::MAY_BUCKLE)).
    ///
    /// ```
    /// use mstmm_core::elements::{Mass, Spring};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{AnyUndamped, ListStep, StepList, Support};
    ///
    /// let steps = [
    ///     ListStep::Tip(Support::Fixed),
    ///     ListStep::Element(AnyUndamped::try_from(Spring { stiffness: 8.0_f64 })?),
    ///     ListStep::Element(Mass { mass: 2.0 }.try_into()?),
    ///     ListStep::Root(Support::Free),
    /// ];
    /// assert_eq!(StepList::new(&steps)?.unstable_modes()?, 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SearchError::Unresolved`] where sums cancel in extended precision, too, or there is none and a mode is next to rest;
    /// [`SearchError::Zero`] for a model in which something is held twice; [`SearchError::NotANumber`] where numbers overflow.
    ///
    /// # Source
    /// Wittrick and Williams, whose count holds for ω² of either sign.
    #[inline]
    fn unstable_modes(&self) -> Result<u64, SearchError>
    where
        Self: Undamped,
    {
        Isolation::<Self, Self::Parameter>::new(self).unstable_modes()
    }

    /// Every natural frequency in a range [rad/s], each certified, with multiplicity.
    ///
    /// A frequency belongs to the range if its certified interval meets it; ω = 0, with the number of rigid-body modes
    /// as its multiplicity, belongs to a range that starts at 0.
    ///
    /// # Errors
    /// [`SearchError`] for a range that is empty, negative or not finite, more than `CAP` entries, a Δ that is not finite somewhere in the
    /// range, or a system with motions that grow.
    #[inline]
    fn natural_frequencies<const CAP: usize>(
        &self,
        range: RangeInclusive<Self::Parameter>,
    ) -> Result<FrequencyList<Self::Parameter, CAP>, SearchError>
    where
        Self: Undamped,
    {
        let mut plain = Isolation::<Self, Self::Parameter>::new(self);
        plain.check_stability()?;
        if let Some(found) = Together::new(&mut plain).and_then(|together| together.in_range(&range)) {
            return Ok(found);
        }
        let found = plain.in_range(*range.start(), *range.end());
        judged(self, found, plain.is_doubtful, Some(range))
    }

    /// The lowest natural frequencies, rigid-body modes at ω = 0 included: the fewest entries whose multiplicities add up
    /// to at least `N`.
    ///
    /// # Errors
    /// [`SearchError::TooFewRoots`] if the system has no more than it says; else as `natural_frequencies`.
    #[inline]
    fn first_frequencies<const N: usize>(&self) -> Result<FrequencyList<Self::Parameter, N>, SearchError>
    where
        Self: Undamped,
    {
        let mut plain = Isolation::<Self, Self::Parameter>::new(self);
        plain.check_stability()?;
        if let Some(found) = Together::new(&mut plain).and_then(Together::first) {
            return Ok(found);
        }
        let found = plain.first();
        judged(self, found, plain.is_doubtful, None)
    }
}

impl<Y: System + ?Sized> NaturalFrequencies for Y {}

/// Relative distance on both sides of a frequency at which counts are taken, in square roots of eps. Where several paths share a
/// frequency, rounding may move counts to the other side within a tenth of it.
const COUNT_MARGIN: f64 = 256.0;

/// The relative distance at which counts are taken, for numbers of type `T`.
#[inline]
pub(crate) fn count_margin<T: Real>() -> T {
    T::from_f64(T::EPSILON).sqrt() * T::from_f64(COUNT_MARGIN)
}

/// Relative distance at which counts are taken in extended precision, in units in the last place of a parameter.
const EXTENDED_MARGIN: f64 = 4.0;

/// The count near a frequency, if it is equal on both sides and no sum cancelled.
#[inline]
fn count_beside<Y, T>(system: &Y, omega: T) -> Result<Option<u64>, SearchError>
where
    T: Real,
    Y: Characteristic<T> + ?Sized,
{
    let away = omega * count_margin();
    let both = [omega - away, omega + away].map(|x| count_and_value::<true, _, _>(system, x));
    agreed(omega, both)
}

/// The count on which the passes below and above a frequency agree, if no sum cancelled in them.
#[inline]
pub(crate) fn agreed<T: Real>(
    omega: T,
    [(below, at_below), (above, at_above)]: [(WittrickWilliams, Scaled<T>); 2],
) -> Result<Option<u64>, SearchError> {
    let [lower, upper] = [at_below, at_above].map(|value| value.mantissa());
    if !(lower.size().is_finite() && upper.size().is_finite()) {
        return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
    }
    let is_clear = !(lower.is_zero() || upper.is_zero() || below.cancelled().any() || above.cancelled().any());
    Ok((is_clear && below.below() == above.below()).then_some(below.below()))
}

/// The count in extended precision.
#[cold]
#[inline(never)]
fn extended_count<Y, T>(system: &Y, omega: T) -> Result<u64, SearchError>
where
    T: Real,
    Y: Characteristic<T::Extended> + Characteristic<Dual<T::Extended>> + System<Parameter = T> + ?Sized,
{
    let mut judge = Isolation::<Y, T::Extended>::new(system);
    let x = <T::Extended as Frequency<T>>::from_parameter(omega);
    let away = x * <T::Extended as Scalar>::from_f64(EXTENDED_MARGIN * T::EPSILON);
    let (below, above) = (judge.sample(x - away)?, judge.sample(x + away)?);
    let is_clear = !(below.value.mantissa().is_zero() || above.value.mantissa().is_zero());
    if is_clear && below.below == above.below {
        return Ok(below.below);
    }
    Err(SearchError::Unresolved { near: omega.to_f64() })
}

/// The result of a search in a range or of the lowest frequencies. Where it is doubtful, extended precision confirms it by counts, or
/// searches anew.
#[inline]
fn judged<Y: Undamped + ?Sized, const CAP: usize>(
    system: &Y,
    found: Result<FrequencyList<Y::Parameter, CAP>, SearchError>,
    is_doubtful: bool,
    range: Option<RangeInclusive<Y::Parameter>>,
) -> Result<FrequencyList<Y::Parameter, CAP>, SearchError> {
    if !is_doubtful {
        return found;
    }
    if !Y::Parameter::HAS_EXTENDED {
        let near = |list: FrequencyList<Y::Parameter, CAP>| list.first().map_or(0.0, |root| root.omega.to_f64());
        let refused = |list| {
            if refuses_doubt::<Y::Parameter>() { Err(SearchError::Unresolved { near: near(list) }) } else { Ok(list) }
        };
        return found.and_then(refused);
    }
    let mut judge = Isolation::<Y, <Y::Parameter as Real>::Extended>::new(system);
    let range = range.map(|range| [*range.start(), *range.end()].map(Frequency::from_parameter));
    // those of the search before
    let mut plain = 0;
    if let Ok(found) = &found {
        judge.evaluations = found.evaluations;
        plain = found.evaluations - found.extended;
        // where counts fail, a search says why
        if judge.confirms(found, range).unwrap_or(false) {
            let (evaluations, extended) = (judge.evaluations, judge.evaluations - plain);
            return Ok(FrequencyList { evaluations, extended, ..*found });
        }
    }
    let judged = match range {
        Some([start, end]) => judge.in_range::<CAP>(start, end)?,
        None => judge.first()?,
    };
    let mut frequencies = List::new();
    for root in &judged {
        let [omega, lower, upper] = [root.omega, root.lower, root.upper].map(|x| Scalar::from_f64(x.to_f64()));
        let root = NaturalFrequency { omega, lower, upper, multiplicity: root.multiplicity };
        frequencies.push(root).map_err(|_| SearchError::Capacity { capacity: CAP })?;
    }
    let evaluations = judged.evaluations;
    Ok(FrequencyList { frequencies, evaluations, extended: evaluations - plain })
}

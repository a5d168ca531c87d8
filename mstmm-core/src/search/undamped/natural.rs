//! Natural frequencies of undamped systems: the trait that users call.

use crate::model::SearchError;
use crate::number::{Dual, Frequency, List, Parameter, Real, Scalar, Scaled, Store, refuses_doubt};
use crate::pass::characteristic::{Characteristic, System, counted_pass};
use crate::pass::searched::Undamped;
use crate::search::closed_range::ClosedRange;
use crate::search::room::add;
use crate::search::undamped::found::{Found, FrequencyList, NaturalFrequency};
use crate::search::undamped::sampling::Isolation;
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
        range: impl ClosedRange<Self::Parameter>,
    ) -> Result<FrequencyList<Self::Parameter, CAP>, SearchError>
    where
        Self: Undamped,
    {
        in_range::<_, List<_, CAP>>(self, range.closed()).map(FrequencyList::from)
    }

    /// Every natural frequency in a range [rad/s], as [`natural_frequencies`](NaturalFrequencies::natural_frequencies) finds them, in a
    /// vector, which holds as many as there are.
    ///
    /// ```
    /// use mstmm_core::elements::{Mass, Spring};
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{AnyUndamped, ListStep, StepList, Support};
    ///
    /// // a hundred masses between springs: ω = 2 sin(kπ/201) for odd k
    /// let mut steps = vec![ListStep::Tip(Support::Fixed)];
    /// for _ in 0..100 {
    ///     steps.push(ListStep::Element(AnyUndamped::try_from(Spring { stiffness: 1.0_f64 })?));
    ///     steps.push(ListStep::Element(Mass { mass: 1.0 }.try_into()?));
    /// }
    /// steps.push(ListStep::Root(Support::Free));
    /// let found = StepList::new(&steps)?.frequencies_in(0.0..=1.0)?;
    /// let expected = (1..=200).step_by(2).map(|k| 2.0 * (f64::from(k) * std::f64::consts::PI / 402.0).sin());
    /// assert_eq!(found.len(), expected.filter(|omega| *omega <= 1.0).count());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`natural_frequencies`](NaturalFrequencies::natural_frequencies); [`SearchError::Capacity`] only where memory ends.
    #[cfg(feature = "std")]
    fn frequencies_in(
        &self,
        range: impl ClosedRange<Self::Parameter>,
    ) -> Result<std::vec::Vec<NaturalFrequency<Self::Parameter>>, SearchError>
    where
        Self: Undamped,
    {
        in_range::<_, std::vec::Vec<_>>(self, range.closed()).map(|found| found.frequencies)
    }

    /// The lowest natural frequencies, rigid-body modes at ω = 0 included: the fewest entries whose multiplicities add up
    /// to at least `N`, a number known at compile time, `first_frequencies::<3>()`.
    ///
    /// A rigid-body mode counts once here; each rigid-body mode is two eigenvalues of
    /// [`first_eigenvalues`](crate::search::Eigenvalues::first_eigenvalues).
    ///
    /// # Errors
    /// [`SearchError::TooFewRoots`] if the system has no more than it says; else as `natural_frequencies`.
    #[inline]
    fn first_frequencies<const N: usize>(&self) -> Result<FrequencyList<Self::Parameter, N>, SearchError>
    where
        Self: Undamped,
    {
        first::<_, List<_, N>>(self, N as u64).map(FrequencyList::from)
    }

    /// The lowest natural frequencies, as [`first_frequencies`](NaturalFrequencies::first_frequencies) finds them, where their number n
    /// is known when the program runs: the fewest entries whose multiplicities add up to at least n.
    ///
    /// ```
    /// use mstmm_core::elements::Beam;
    /// use mstmm_core::search::NaturalFrequencies;
    /// use mstmm_core::{AnyUndamped, ListStep, StepList, Support};
    ///
    /// let beam = Beam { length: 1.0_f64, bending_stiffness: 1.0, mass_per_length: 1.0 };
    /// let steps = [
    ///     ListStep::Tip(Support::Pinned),
    ///     ListStep::Element(AnyUndamped::try_from(beam)?),
    ///     ListStep::Root(Support::Pinned),
    /// ];
    /// let found = StepList::new(&steps)?.frequencies("20".parse()?)?;
    /// assert!((found[19].omega.sqrt() / (20.0 * std::f64::consts::PI) - 1.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`first_frequencies`](NaturalFrequencies::first_frequencies); [`SearchError::Capacity`] only where memory ends.
    #[cfg(feature = "std")]
    fn frequencies(&self, n: usize) -> Result<std::vec::Vec<NaturalFrequency<Self::Parameter>>, SearchError>
    where
        Self: Undamped,
    {
        first::<_, std::vec::Vec<_>>(self, n as u64).map(|found| found.frequencies)
    }
}

impl<Y: System + ?Sized> NaturalFrequencies for Y {}

/// The result of a search that collects frequencies in a list of type `L`.
type Searched<L> = Result<Found<L>, SearchError>;

/// Every frequency in a range.
#[inline]
fn in_range<Y, L>(system: &Y, range: RangeInclusive<Y::Parameter>) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    let mut plain = Isolation::<Y, Y::Parameter>::new(system);
    plain.check_stability()?;
    if let Some(found) = Together::new(&mut plain).and_then(|together| together.in_range(&range)) {
        return Ok(found);
    }
    let (start, end) = range.into_inner();
    let found = plain.in_range(start, end);
    judged(system, found, plain.is_doubtful, Sought::Range([start, end]))
}

/// The lowest frequencies, so many of them.
#[inline]
fn first<Y, L>(system: &Y, wanted: u64) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    let mut plain = Isolation::<Y, Y::Parameter>::new(system);
    plain.check_stability()?;
    if let Some(found) = Together::new(&mut plain).and_then(|together| together.first(wanted)) {
        return Ok(found);
    }
    let found = plain.first(wanted);
    judged(system, found, plain.is_doubtful, Sought::Lowest(wanted))
}

/// What a search is asked for.
#[derive(Clone, Copy)]
enum Sought<T> {
    /// All frequencies between two ends.
    Range([T; 2]),
    /// So many of the lowest.
    Lowest(u64),
}

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
    Y: System + Characteristic<T> + ?Sized,
{
    let away = omega * count_margin();
    // fronts know what rounding has done to them where they are looked at as beside a root
    let counter = || WittrickWilliams::new(Y::IS_NETWORK);
    agreed(omega, [omega - away, omega + away].map(|x| counted_pass(system, x, counter())))
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
    let is_lost = [below.cancelled(), above.cancelled()].iter().any(|cancelled| cancelled.any() || cancelled.at_root);
    let is_clear = !(lower.is_zero() || upper.is_zero() || is_lost);
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
fn judged<Y, L>(system: &Y, found: Searched<L>, is_doubtful: bool, sought: Sought<Y::Parameter>) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    if !is_doubtful {
        return found;
    }
    if !Y::Parameter::HAS_EXTENDED {
        let near = |list: Found<L>| list.frequencies.first().map_or(0.0, |root| root.omega.to_f64());
        let refused = |list| {
            if refuses_doubt::<Y::Parameter>() { Err(SearchError::Unresolved { near: near(list) }) } else { Ok(list) }
        };
        return found.and_then(refused);
    }
    let mut judge = Isolation::<Y, <Y::Parameter as Real>::Extended>::new(system);
    let range = match sought {
        Sought::Range(ends) => Some(ends.map(Frequency::from_parameter)),
        Sought::Lowest(_) => None,
    };
    // those of the search before
    let mut plain = 0;
    if let Ok(found) = found {
        judge.evaluations = found.evaluations;
        plain = found.evaluations - found.extended;
        // where counts fail, a search says why
        if judge.confirms(&found.frequencies, range).unwrap_or(false) {
            let (evaluations, extended) = (judge.evaluations, judge.evaluations - plain);
            return Ok(Found { evaluations, extended, ..found });
        }
    }
    let judged: Found<L::Of<NaturalFrequency<<Y::Parameter as Real>::Extended>>> = match sought {
        Sought::Range(ends) => {
            let [start, end] = ends.map(Frequency::from_parameter);
            judge.in_range(start, end)?
        }
        Sought::Lowest(wanted) => judge.first(wanted)?,
    };
    let mut frequencies = L::empty();
    for root in judged.frequencies.iter() {
        let [omega, lower, upper] = [root.omega, root.lower, root.upper].map(|x| Scalar::from_f64(x.to_f64()));
        add(&mut frequencies, NaturalFrequency { omega, lower, upper, multiplicity: root.multiplicity })?;
    }
    let evaluations = judged.evaluations;
    Ok(Found { frequencies, evaluations, extended: evaluations - plain })
}

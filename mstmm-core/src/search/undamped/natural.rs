//! Natural frequencies of undamped systems: the trait that users call.

use crate::model::SearchError;
use crate::number::{List, Parameter, Real, Scalar, Store};
use crate::pass::characteristic::{System, counted_pass};
use crate::pass::searched::Undamped;
use crate::search::closed_range::ClosedRange;
use crate::search::undamped::found::{Found, FrequencyList, NaturalFrequency};
use crate::search::undamped::proven::{Certification, Parts, Sought};
use crate::search::undamped::sampling::Isolation;
use crate::search::undamped::together::Together;
use crate::subspace::WittrickWilliams;
use num_traits::Zero;

/// The proven searches of undamped systems.
///
/// A fast search proposes frequencies, and a proof decides: bounds of the count of Wittrick and Williams at both ends of an interval, with all
/// rounding in them, in two words and where these do not do in four. What is not proven is bisected by proven counts, or refused with numbers,
/// [`Unproven`](SearchError::Unproven). Without the feature `proof`, and for a system with an element that is known by its transfer matrix
/// alone, results are those of the fast search: [`is_proven`](NaturalFrequency::is_proven) is false.
///
/// A system with motions that grow, as of a column that buckles, has no list of frequencies: its searches say
/// [`Unstable`](SearchError::Unstable). Frequencies at zero are those of rigid bodies and of what is just about to buckle.
///
/// A thread of 128 kB is enough, of 384 kB in debug builds.
pub trait NaturalFrequencies: System {
    /// Number of natural frequencies below `omega` [rad/s], with multiplicity; rigid-body modes count from ω > 0 on. It is 0 for
    /// `omega <= 0`.
    ///
    /// # Errors
    /// [`SearchError::Unstable`] for a system with motions that grow; [`SearchError::Unproven`] where rounding decides the count in four words,
    /// as at a frequency itself; [`SearchError::Zero`] for a model in which something is held twice, or by nothing.
    ///
    /// # Source
    /// Wittrick and Williams: the clamped counts of members and the negative pivots of the dynamic stiffness.
    #[inline]
    fn count_below(&self, omega: Self::Parameter) -> Result<u64, SearchError>
    where
        Self: Undamped,
    {
        if omega <= Self::Parameter::zero() {
            return Ok(0);
        }
        if !omega.size().is_finite() {
            return Err(SearchError::NotANumber { x: omega.to_f64(), y: 0.0 });
        }
        let parts = Parts(self);
        match certification(self, &parts) {
            Some(mut certification) => {
                if const { Self::MAY_BUCKLE } && self.may_buckle() {
                    certification.check_stability()?;
                }
                certification.count(omega)
            }
            None => {
                check_counted_stability(self)?;
                Ok(counted_pass(self, omega, WittrickWilliams::<f64>::default()).0.below())
            }
        }
    }

    /// Bounds of the number of natural frequencies below `omega` [rad/s], motions that grow included: at least so many, and at most so many. Both are
    /// proven; they differ where rounding decides the count, as at a frequency itself.
    ///
    /// Where nothing is known, as without the feature `proof`, they are 0 and `u64::MAX`.
    #[inline]
    fn count_bounds(&self, omega: Self::Parameter) -> [u64; 2]
    where
        Self: Undamped,
    {
        let parts = Parts(self);
        let bounds = certification(self, &parts).map(|mut proof| proof.prover.bounds(omega, 1.0));
        let [least, most] = bounds.unwrap_or_default();
        [least.unwrap_or(0), most.unwrap_or(u64::MAX)]
    }

    /// Number of motions that grow: of modes with `ω² < 0`, as those of a column under more than its buckling load. Each has a pair of
    /// real eigenvalues ±λ, which [`eigenvalues`](crate::search::Eigenvalues::eigenvalues) finds.
    ///
    /// It is the count J at `ω² = 0`; where something rests, at `ω² = -ε²`, with ε below all frequencies but those that are zero. No system is
    /// evaluated whose elements all have positive stiffness ([`Element::MAY_BUCKLE`](crate::element::Element::MAY_BUCKLE)).
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
    /// [`SearchError::Unproven`] where rounding decides it in four words, and where nothing is proven;
    /// [`SearchError::Zero`] for a model in which something is held twice, or by nothing.
    ///
    /// # Source
    /// Wittrick and Williams, whose count holds for ω² of either sign.
    #[inline]
    fn unstable_modes(&self) -> Result<u64, SearchError>
    where
        Self: Undamped,
    {
        if const { !Self::MAY_BUCKLE } || !self.may_buckle() {
            return Ok(0);
        }
        match certification(self, &Parts(self)) {
            Some(mut certification) => certification.unstable_modes(),
            None => counted_unstable_modes(self),
        }
    }

    /// Every natural frequency in a range [rad/s], each proven, with multiplicity.
    ///
    /// A frequency belongs to the range if its interval meets it; ω = 0, with the number of rigid-body modes
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
        in_range::<_, List<_, CAP>>(self, ends(range)).map(FrequencyList::from)
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
        in_range::<_, std::vec::Vec<_>>(self, ends(range)).map(|found| found.frequencies)
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
        searched::<_, List<_, N>>(self, Sought::Lowest(N as u64)).map(FrequencyList::from)
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
        searched::<_, std::vec::Vec<_>>(self, Sought::Lowest(n as u64)).map(|found| found.frequencies)
    }

    /// Estimates of the lowest natural frequencies, at the cost of the fast search alone: nothing is proven, and one that is missed is missed.
    ///
    /// # Errors
    /// As [`first_frequencies`](NaturalFrequencies::first_frequencies).
    #[inline]
    fn estimates<const N: usize>(&self) -> Result<FrequencyList<Self::Parameter, N>, SearchError>
    where
        Self: Undamped,
    {
        proposed::<_, List<_, N>>(self, Sought::Lowest(N as u64)).map(FrequencyList::from)
    }
}

impl<Y: System + ?Sized> NaturalFrequencies for Y {}

/// The result of a search that collects frequencies in a list of type `L`.
type Searched<L> = Result<Found<L>, SearchError>;

/// The two ends of a range.
fn ends<T: Real>(range: impl ClosedRange<T>) -> [T; 2] {
    let (start, end) = range.closed().into_inner();
    [start, end]
}

/// What proves claims about a system; none without the feature `proof`, and where a part of it is not known in numbers.
#[inline]
pub(crate) fn certification<'a, Y: Undamped + ?Sized>(
    system: &Y,
    parts: &'a Parts<'_, Y>,
) -> Option<Certification<'a, Y::Parameter>> {
    if cfg!(feature = "proof") { Certification::new(parts, system.frequency_estimates()) } else { None }
}

/// Every frequency in a range.
#[inline]
fn in_range<Y, L>(system: &Y, [start, end]: [Y::Parameter; 2]) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    let valid = start >= Y::Parameter::zero() && start < end && end.size().is_finite();
    if !valid {
        return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() });
    }
    searched::<Y, L>(system, Sought::Range([start, end])).and_then(|found| found.meeting([start, end]))
}

/// The proven list of the lowest frequencies, given what is proposed for it.
#[inline]
pub(super) fn proven_list<Y, const N: usize>(
    system: &Y,
    proposals: Found<List<NaturalFrequency<Y::Parameter>, N>>,
) -> Result<FrequencyList<Y::Parameter, N>, SearchError>
where
    Y: Undamped + ?Sized,
{
    proven(system, Sought::Lowest(N as u64), || Ok(proposals)).map(FrequencyList::from)
}

/// What is sought, proven where that can be.
#[inline]
fn searched<Y, L>(system: &Y, sought: Sought<Y::Parameter>) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    proven(system, sought, || proposed(system, sought))
}

/// What is sought, proven where that can be, given what is proposed.
#[inline]
fn proven<Y, L>(system: &Y, sought: Sought<Y::Parameter>, proposed: impl FnOnce() -> Searched<L>) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    let parts = Parts(system);
    let Some(mut certification) = certification(system, &parts) else {
        check_counted_stability(system)?;
        return complete(proposed()?, sought);
    };
    if const { Y::MAY_BUCKLE } && system.may_buckle() {
        certification.check_stability()?;
    }
    let proposals = proposed();
    let (list, evaluations) = match &proposals {
        Ok(found) => (&*found.frequencies, found.evaluations),
        Err(_) => (&[][..], 0),
    };
    match certification.certified(list, sought) {
        Ok(frequencies) => Ok(Found { frequencies, evaluations, runs: certification.runs() }),
        // the search knows better what is wrong with numbers
        Err(error @ SearchError::Unproven { .. }) => Err(proposals.err().filter(is_about_numbers).unwrap_or(error)),
        Err(error) => Err(error),
    }
}

/// The number of motions that grow where nothing is proven: the count at rest, unless something rests.
fn counted_unstable_modes<Y: Undamped + ?Sized>(system: &Y) -> Result<u64, SearchError> {
    let (count, delta) = counted_pass(system, Y::Parameter::zero(), WittrickWilliams::<f64>::default());
    let size = delta.mantissa().size();
    if size.is_finite() && size > 0.0 {
        return Ok(count.below());
    }
    Err(SearchError::Unproven { near: 0.0, at_most: u64::MAX, at_least: 0 })
}

/// Refuses a system with motions that grow where nothing is proven.
fn check_counted_stability<Y: Undamped + ?Sized>(system: &Y) -> Result<(), SearchError> {
    if const { !Y::MAY_BUCKLE } || !system.may_buckle() {
        return Ok(());
    }
    match counted_unstable_modes(system)? {
        0 => Ok(()),
        modes => Err(SearchError::Unstable { modes }),
    }
}

/// A list that nobody proves, if it is as long as was asked for.
fn complete<T: Real, L: Store<NaturalFrequency<T>>>(found: Found<L>, sought: Sought<T>) -> Searched<L> {
    let count = found.frequencies.last().map_or(0, |last| last.index + last.multiplicity - 1);
    match sought {
        Sought::Lowest(wanted) if count < wanted => Err(SearchError::TooFewRoots { found: count, wanted }),
        _ => Ok(found),
    }
}

/// Whether an error says that numbers leave their range.
fn is_about_numbers(error: &SearchError) -> bool {
    matches!(error, SearchError::NotANumber { .. })
}

/// What the fast search proposes.
#[inline]
fn proposed<Y, L>(system: &Y, sought: Sought<Y::Parameter>) -> Searched<L>
where
    Y: Undamped + ?Sized,
    L: Store<NaturalFrequency<Y::Parameter>>,
{
    let mut isolation = Isolation::<Y, Y::Parameter>::new(system);
    let together = Together::new(&mut isolation).and_then(|together| match sought {
        Sought::Range(range) => together.in_range(range),
        Sought::Lowest(wanted) => together.first(wanted),
    });
    if let Some(found) = together {
        return Ok(found);
    }
    match sought {
        Sought::Range([start, end]) => isolation.in_range(start, end),
        Sought::Lowest(wanted) => isolation.first(wanted),
    }
}

//! Natural frequencies of undamped systems: what users call.

use super::certified::Isolation;
use crate::block::natural_count;
use crate::characteristic::{Characteristic, System, count_and_value};
use crate::error::SearchError;
use crate::list::List;
use crate::scalar::{Dual, Real, Scalar};
use core::fmt;
use core::ops::{Deref, RangeInclusive};

/// A natural frequency, certified by the count just below and just above it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NaturalFrequency<T = f64> {
    /// Angular frequency ω [rad/s].
    pub omega: T,
    /// Lower end of the certified interval [rad/s]: no more than the frequencies listed before lie below.
    pub lower: T,
    /// Upper end of the certified interval [rad/s].
    pub upper: T,
    /// Number of frequencies in the interval: more than one where several coincide, or where the arithmetic cannot tell
    /// them apart.
    pub multiplicity: u64,
}

impl<T: Real> NaturalFrequency<T> {
    /// Frequency in Hz, ω/2π.
    pub fn hertz(&self) -> T {
        self.omega * T::from_f64(core::f64::consts::TAU.recip())
    }
}

/// Frequencies in ascending order and the number of evaluations they took; dereferences to a slice.
///
/// An evaluation is one pass, of Δ with or without its count; a pass that also gives the derivative counts as two.
#[derive(Clone, Copy, Debug)]
pub struct FrequencyList<T, const CAP: usize> {
    pub(super) frequencies: List<NaturalFrequency<T>, CAP>,
    pub(super) evaluations: usize,
}

impl<T, const CAP: usize> FrequencyList<T, CAP> {
    /// Number of evaluations.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }
}

impl<T, const CAP: usize> Deref for FrequencyList<T, CAP> {
    type Target = [NaturalFrequency<T>];

    fn deref(&self) -> &[NaturalFrequency<T>] {
        &self.frequencies
    }
}

impl<'a, T, const CAP: usize> IntoIterator for &'a FrequencyList<T, CAP> {
    type Item = &'a NaturalFrequency<T>;
    type IntoIter = core::slice::Iter<'a, NaturalFrequency<T>>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: Real + fmt::Display> fmt::Display for NaturalFrequency<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rad/s", self.omega)?;
        if self.multiplicity > 1 { write!(f, " ({} times)", self.multiplicity) } else { Ok(()) }
    }
}

/// A system that can be searched for natural frequencies: Δ and its derivative in the arithmetic of the parameters, and in
/// the arithmetic that judges its rounding.
///
/// Every undamped system without planar elements is one; systems with a damper are not: they have `eigenvalues`.
pub trait Undamped:
    System
    + Characteristic<<Self as System>::Parameter>
    + Characteristic<Dual<<Self as System>::Parameter>>
    + Characteristic<<<Self as System>::Parameter as Real>::Judge>
    + Characteristic<Dual<<<Self as System>::Parameter as Real>::Judge>>
{
}

impl<Y> Undamped for Y where
    Y: System
        + Characteristic<<Y as System>::Parameter>
        + Characteristic<Dual<<Y as System>::Parameter>>
        + Characteristic<<<Y as System>::Parameter as Real>::Judge>
        + Characteristic<Dual<<<Y as System>::Parameter as Real>::Judge>>
        + ?Sized
{
}

/// The certified searches of undamped systems.
///
/// Where a result looks as if rounding had a hand in it (roots that coincide or nearly do, slopes that do not fit), the
/// search is made again in the arithmetic that judges the first: double-double for `f64`.
pub trait NaturalFrequencies: System {
    /// Number of natural frequencies below `omega` [rad/s], with multiplicity; rigid-body modes count from ω > 0 on.
    ///
    /// One evaluation, not judged: within 1e-12 of a frequency, relatively, or within 1e-7 of one that several paths share,
    /// rounding may put the count on the other side. The searches do not rest on a single count.
    ///
    /// No frequency is below zero, a negative number or a NaN; at an `omega` so large that the arithmetic overflows, the
    /// count is `u64::MAX`.
    ///
    /// # Source
    /// Wittrick and Williams along the tree of transfer paths.
    fn count_below(&self, omega: Self::Parameter) -> u64
    where
        Self: Characteristic<<Self as System>::Parameter>,
    {
        let (below, value) = count_and_value(self, omega);
        natural_count(omega, below, value)
    }

    /// Every natural frequency in a range [rad/s], each certified, with multiplicity.
    ///
    /// A frequency belongs to the range if its certified interval meets it; ω = 0, with the number of rigid-body modes
    /// as its multiplicity, belongs to a range that starts at 0.
    ///
    /// # Errors
    /// [`SearchError`] for a range that is empty, negative or not finite, more than `CAP` entries, or a Δ that is not
    /// finite somewhere in the range.
    fn natural_frequencies<const CAP: usize>(
        &self,
        range: RangeInclusive<Self::Parameter>,
    ) -> Result<FrequencyList<Self::Parameter, CAP>, SearchError>
    where
        Self: Undamped,
    {
        let mut plain = Isolation::<Self, Self::Parameter>::new(self);
        let found = plain.in_range(*range.start(), *range.end());
        judged::<Self, CAP>(found, plain.is_doubtful, || {
            let [start, end] = [range.start(), range.end()].map(|end| Scalar::from_f64(end.to_f64()));
            Isolation::<Self, <Self::Parameter as Real>::Judge>::new(self).in_range(start, end)
        })
    }

    /// The lowest natural frequencies, rigid-body modes at ω = 0 included: the fewest entries whose multiplicities add up
    /// to at least `N`.
    ///
    /// # Errors
    /// [`SearchError::TooFewRoots`] if the system has no more than it says; else as `natural_frequencies`.
    fn first_frequencies<const N: usize>(&self) -> Result<FrequencyList<Self::Parameter, N>, SearchError>
    where
        Self: Undamped,
    {
        let mut plain = Isolation::<Self, Self::Parameter>::new(self);
        let found = plain.first();
        judged::<Self, N>(found, plain.is_doubtful, || {
            Isolation::<Self, <Self::Parameter as Real>::Judge>::new(self).first()
        })
    }
}

impl<Y: System + ?Sized> NaturalFrequencies for Y {}

/// What was found, or where that is doubtful what the judging arithmetic finds.
fn judged<Y: System + ?Sized, const CAP: usize>(
    found: Result<FrequencyList<Y::Parameter, CAP>, SearchError>,
    is_doubtful: bool,
    judge: impl FnOnce() -> Result<FrequencyList<<Y::Parameter as Real>::Judge, CAP>, SearchError>,
) -> Result<FrequencyList<Y::Parameter, CAP>, SearchError> {
    if !(is_doubtful && Y::Parameter::HAS_JUDGE) {
        return found;
    }
    let plain = found.map_or(0, |found| found.evaluations);
    let judged = judge()?;
    let mut frequencies = List::new();
    for root in &judged {
        let [omega, lower, upper] = [root.omega, root.lower, root.upper].map(|x| Scalar::from_f64(x.to_f64()));
        let root = NaturalFrequency { omega, lower, upper, multiplicity: root.multiplicity };
        frequencies.push(root).map_err(|_| SearchError::Capacity { capacity: CAP })?;
    }
    Ok(FrequencyList { frequencies, evaluations: plain + judged.evaluations })
}

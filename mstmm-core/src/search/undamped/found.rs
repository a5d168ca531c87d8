//! Natural frequencies that were found.

use crate::model::turns;
use crate::number::{List, Real};
use core::fmt;
use core::ops::Deref;

/// A natural frequency with the interval that holds it.
///
/// Where it [is proven](Self::is_proven), the count of natural frequencies is at most `index - 1` at `lower` and at least
/// `index + multiplicity - 1` at `upper`: so the frequencies of these indices lie in `[lower, upper)`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NaturalFrequency<T = f64> {
    /// Angular frequency ω [rad/s].
    pub omega: T,
    /// Lower end of the interval [rad/s].
    pub lower: T,
    /// Upper end of the interval [rad/s].
    pub upper: T,
    /// Number of frequencies in the interval: more than one where several are within a few units in the last place.
    pub multiplicity: u64,
    /// Index of the first of them among all natural frequencies, from 1 on; frequencies at rest have the first ones.
    pub index: u64,
    /// Whether the interval is a theorem; else it was counted in arithmetic of which no bound is known.
    pub is_proven: bool,
}

impl<T: Real> NaturalFrequency<T> {
    /// Frequency `ω/2π` in hertz.
    ///
    /// ```
    /// use mstmm_core::search::NaturalFrequency;
    ///
    /// let root = NaturalFrequency { omega: std::f64::consts::TAU * 25.0, ..NaturalFrequency::default() };
    /// assert_eq!((root.hertz(), root.rpm().round(), root.period()), (25.0, 1500.0, 0.04));
    /// ```
    #[inline]
    pub fn hertz(&self) -> T {
        turns::in_hertz(self.omega)
    }

    /// Speed of a shaft `30 ω/π` [1/min] that turns once in a period.
    #[inline]
    pub fn rpm(&self) -> T {
        turns::rpm(self.omega)
    }

    /// Period `2π/ω` \[s\]; infinite for ω = 0, a motion of rigid bodies, which never comes back.
    #[inline]
    pub fn period(&self) -> T {
        turns::period(self.omega)
    }
}

/// What a search found, and the number of evaluations that it took.
pub(super) struct Found<L> {
    pub(super) frequencies: L,
    pub(super) evaluations: usize,
    /// Runs of the proof in two words and in four.
    pub(super) runs: [usize; 2],
}

/// Frequencies in ascending order and the number of evaluations they took; dereferences to a slice.
///
/// An evaluation is one pass of the search, of Δ with or without its count; a pass that also gives the derivative counts as two.
#[derive(Clone, Copy, Debug)]
pub struct FrequencyList<T, const CAP: usize> {
    pub(super) frequencies: List<NaturalFrequency<T>, CAP>,
    pub(super) evaluations: usize,
    pub(super) runs: [usize; 2],
}

impl<T, const CAP: usize> From<Found<List<NaturalFrequency<T>, CAP>>> for FrequencyList<T, CAP> {
    #[inline]
    fn from(found: Found<List<NaturalFrequency<T>, CAP>>) -> Self {
        let Found { frequencies, evaluations, runs } = found;
        FrequencyList { frequencies, evaluations, runs }
    }
}

impl<T, const CAP: usize> FrequencyList<T, CAP> {
    /// Number of evaluations.
    #[inline]
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// Number of runs of the proof besides: in two words, and in four, where two do not decide.
    #[inline]
    pub fn proof_runs(&self) -> [usize; 2] {
        self.runs
    }
}

impl<T, const CAP: usize> Deref for FrequencyList<T, CAP> {
    type Target = [NaturalFrequency<T>];

    #[inline]
    fn deref(&self) -> &[NaturalFrequency<T>] {
        &self.frequencies
    }
}

impl<'a, T, const CAP: usize> IntoIterator for &'a FrequencyList<T, CAP> {
    type Item = &'a NaturalFrequency<T>;
    type IntoIter = core::slice::Iter<'a, NaturalFrequency<T>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<T: Real + fmt::Display> fmt::Display for NaturalFrequency<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} rad/s, {} Hz", self.omega, self.hertz())?;
        if self.multiplicity > 1 { write!(f, " ({} times)", self.multiplicity) } else { Ok(()) }
    }
}

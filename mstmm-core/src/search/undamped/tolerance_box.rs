//! Ranges of frequencies over all systems whose parameters lie between those of two.

use crate::model::{SearchError, ToleranceError};
use crate::number::{List, Parameter, Real, Scalar};
use crate::pass::characteristic::System;
use crate::pass::searched::Undamped;
use crate::search::closed_range::ClosedRange;
use crate::search::undamped::domination::check_domination;
use crate::search::undamped::found::NaturalFrequency;
use crate::search::undamped::natural::NaturalFrequencies;
use core::ops::RangeInclusive;

/// A box of tolerances between two systems: a soft and heavy one, and a stiff and light one.
///
/// Each frequency of a system whose parameters lie between those of both lies between their frequencies of the same number, and both ends are attained: two searches are exact
/// for all corners of the box and for all that is between. Ranges are by number; modes may cross within them.
///
/// Between two numbers is what lies between them, each parameter by itself. Two inertias are more than a number. That of a body is between two where its mass and its inertia about its
/// mass centre are: an `inertia_about_input` J is between where `J - m c²` is. A tensor of inertia is between two where both differences have no negative moment about any axis: numbers
/// between both are enough where the products of inertia are the same in both.
///
/// ```
/// use mstmm_core::elements::Spring;
/// use mstmm_core::frame::{Frame, Ground};
/// use mstmm_core::search::ToleranceBox;
///
/// let oscillator = |stiffness: f64, mass: f64| {
///     let mut frame = Frame::new();
///     let point = frame.point(0.0);
///     frame.member(point, Ground, Spring { stiffness });
///     frame.mass(point, mass);
///     frame.build()
/// };
/// // 100 N/m to 5 %, 4 kg to 2 %
/// let lot = ToleranceBox::between(oscillator(95.0, 4.08)?, oscillator(105.0, 3.92)?)?;
/// let range = lot.first_frequencies::<1>()?[0];
/// assert!((range.lowest.omega - (95.0_f64 / 4.08).sqrt()).abs() < 1e-14);
/// assert!((range.highest.omega - (105.0_f64 / 3.92).sqrt()).abs() < 1e-14);
/// assert!(lot.is_free_of(5.2..=9.0)?);
/// assert_eq!(lot.count_below(5.0)?, 0..=1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ToleranceBox<Y> {
    soft: Y,
    stiff: Y,
}

/// The range of a frequency of one number over a box.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrequencyRange<T> {
    /// That of the soft system.
    pub lowest: NaturalFrequency<T>,
    /// That of the stiff system.
    pub highest: NaturalFrequency<T>,
}

impl<Y: System> ToleranceBox<Y> {
    /// The box between two systems of one topology and one geometry. Stiffnesses, tensions, axial forces and foundations of the first one are at most those of the second one, masses
    /// and inertias at least; a line without foundation may be longer. All else is the same in both.
    ///
    /// # Errors
    /// [`ToleranceError`] for the first parameter that is not so.
    pub fn between(soft: Y, stiff: Y) -> Result<Self, ToleranceError> {
        check_domination(&soft, &stiff)?;
        Ok(ToleranceBox { soft, stiff })
    }

    /// Both systems.
    pub(crate) fn into_ends(self) -> (Y, Y) {
        (self.soft, self.stiff)
    }

    /// The soft system.
    pub fn soft(&self) -> &Y {
        &self.soft
    }

    /// The stiff system.
    pub fn stiff(&self) -> &Y {
        &self.stiff
    }
}

impl<Y: NaturalFrequencies + Undamped> ToleranceBox<Y> {
    /// The ranges of the first `N` frequencies, each of a multiple one by itself.
    ///
    /// # Errors
    /// [`ToleranceError::Search`] as [`first_frequencies`](NaturalFrequencies::first_frequencies) of both systems.
    pub fn first_frequencies<const N: usize>(&self) -> Result<List<FrequencyRange<Y::Parameter>, N>, ToleranceError> {
        let (soft, stiff) = (self.soft.first_frequencies::<N>()?, self.stiff.first_frequencies::<N>()?);
        Ok(collected(1, |number| range(&soft, &stiff, number)))
    }

    /// The ranges of the first `count` frequencies in a vector, as [`first_frequencies`](ToleranceBox::first_frequencies).
    ///
    /// # Errors
    /// [`ToleranceError::Search`] as [`frequencies`](NaturalFrequencies::frequencies) of both systems.
    #[cfg(feature = "std")]
    pub fn frequencies(&self, count: usize) -> Result<std::vec::Vec<FrequencyRange<Y::Parameter>>, ToleranceError> {
        let (soft, stiff) = (self.soft.frequencies(count)?, self.stiff.frequencies(count)?);
        Ok((1..=count as u64).filter_map(|number| range(&soft, &stiff, number)).collect())
    }

    /// How many frequencies a system of the box may have below ω [rad/s]: at least those of the stiff one, at most those of the soft one.
    ///
    /// # Errors
    /// [`ToleranceError::Search`] as [`count_below`](NaturalFrequencies::count_below) of both systems.
    pub fn count_below(&self, omega: Y::Parameter) -> Result<RangeInclusive<u64>, ToleranceError> {
        Ok(self.stiff.count_below(omega)?..=self.soft.count_below(omega)?)
    }

    /// Whether no system of the box has a frequency in a range [rad/s]: the soft system has no more of them below its end than the stiff one has below its begin. Where it
    /// is not free, a system of the box has a frequency there, or the ranges of two numbers overlap there.
    ///
    /// # Errors
    /// [`ToleranceError::Search`] as [`count_below`](NaturalFrequencies::count_below) of both systems, and for a range that is empty, reversed or not finite.
    pub fn is_free_of(&self, range: impl ClosedRange<Y::Parameter>) -> Result<bool, ToleranceError> {
        let range = range.closed();
        let (start, end) = (*range.start(), *range.end());
        let is_range = start >= Y::Parameter::from_f64(0.0) && start <= end && end.to_f64().is_finite();
        if !is_range {
            return Err(SearchError::Range { start: start.to_f64(), end: end.to_f64() }.into());
        }
        Ok(self.soft.count_below(end)? == self.stiff.count_below(start)?)
    }
}

/// The range of the frequency of a number, from 1 on.
fn range<T: Real>(
    soft: &[NaturalFrequency<T>],
    stiff: &[NaturalFrequency<T>],
    number: u64,
) -> Option<FrequencyRange<T>> {
    let of = |roots| of_number(roots, number, |root: &NaturalFrequency<T>| [root.index, root.multiplicity]);
    Some(FrequencyRange { lowest: of(soft)?, highest: of(stiff)? })
}

/// What has a number in a list, given the index and the multiplicity of each.
pub(crate) fn of_number<C: Copy>(list: &[C], number: u64, numbers_of: impl Fn(&C) -> [u64; 2]) -> Option<C> {
    let has_number = |own: &&C| {
        let [index, multiplicity] = numbers_of(own);
        (index..index + multiplicity).contains(&number)
    };
    list.iter().find(has_number).copied()
}

/// The ranges of numbers from a first one on, as many as there is room for.
pub(crate) fn collected<R: Copy + Default, const CAP: usize>(
    first: u64,
    range: impl Fn(u64) -> Option<R>,
) -> List<R, CAP> {
    let mut ranges = List::new();
    (first..first + CAP as u64).filter_map(range).try_for_each(|range| ranges.push(range)).ok();
    ranges
}

//! How much of the mass each mode takes with it.

use crate::model::MotionError;
use crate::number::{List, Real};

/// The factor of participation of a shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ParticipationFactor<T> {
    /// The place of the root of the shape in the list, from 0 on.
    pub root: usize,
    /// The factor Γ [kg^½]: what a weight of 1 m/s² works on the shape of unit modal mass. Its sign is that of the shape.
    pub value: T,
}

/// Factors of participation and effective masses of modes along a direction; about an axis these are moments of inertia [kg m²].
///
/// A mode of the factor Γ moves as much as a mass of Γ² would, of which the ground feels the inertia. All modes together have the
/// [total](Participation::total): what no support holds. Of a multiple root the sum over its shapes counts, which no choice of the shapes changes.
///
/// ```
/// use mstmm_core::frame::{Frame, Section};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{Direction, FrameAnalysis, Support};
///
/// let mut frame = Frame::new();
/// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
/// frame.hold(foot, Support::Fixed);
/// frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
/// let cantilever = frame.build()?;
/// let roots = cantilever.frequencies(3)?;
/// let participation = cantilever.participation::<3, _>(&roots, Direction::y())?;
/// // of its 3 kg the modes have 61.3 %, 18.8 % and 6.5 %: three leave out 13 %
/// let shares = [0, 1, 2].map(|mode| participation.effective_mass(mode) / participation.total());
/// assert!(shares.iter().zip([0.6131, 0.1883, 0.0647]).all(|(share, known)| (share - known).abs() < 5e-5));
/// assert!((participation.missing() / 3.0 - 0.134).abs() < 5e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Participation<T, const N: usize> {
    factors: List<ParticipationFactor<T>, N>,
    total: T,
}

/// Keeps the factor of each shape of some roots, given what hands on the factors of the shapes of one root.
pub(crate) fn collect<'r, T, R: 'r>(
    roots: impl IntoIterator<Item = &'r R>,
    for_each_factor: impl Fn(&R, &mut dyn FnMut(T) -> Result<(), MotionError>) -> Result<(), MotionError>,
    mut keep: impl FnMut(ParticipationFactor<T>) -> Result<(), MotionError>,
) -> Result<(), MotionError> {
    for (place, root) in roots.into_iter().enumerate() {
        for_each_factor(root, &mut |value| keep(ParticipationFactor { root: place, value }))?;
    }
    Ok(())
}

impl<T: Real, const N: usize> Participation<T, N> {
    /// The factors of all shapes of some roots, given what hands on the factors of the shapes of one root.
    pub(crate) fn new<'r, R: 'r>(
        total: T,
        roots: impl IntoIterator<Item = &'r R>,
        for_each_factor: impl Fn(&R, &mut dyn FnMut(T) -> Result<(), MotionError>) -> Result<(), MotionError>,
    ) -> Result<Self, MotionError> {
        let mut factors = List::new();
        collect(roots, for_each_factor, |factor| {
            factors.push(factor).map_err(|_| MotionError::Capacity { capacity: N })
        })?;
        Ok(Participation { factors, total })
    }

    /// The factor of each shape. The shapes of a multiple root follow one after the other.
    pub fn factors(&self) -> &[ParticipationFactor<T>] {
        &self.factors
    }

    /// The effective mass of a root by its place in the list, from 0 on \[kg\]: the sum of Γ² over its shapes.
    pub fn effective_mass(&self, root: usize) -> T {
        self.sum(|factor| factor.root == root)
    }

    /// The effective mass of all roots up to one, that included \[kg\].
    pub fn cumulative(&self, root: usize) -> T {
        self.sum(|factor| factor.root <= root)
    }

    /// The mass that all modes together move along the direction \[kg\].
    pub fn total(&self) -> T {
        self.total
    }

    /// The effective mass of all modes that are not in the list \[kg\].
    pub fn missing(&self) -> T {
        self.total - self.sum(|_| true)
    }

    fn sum(&self, counts: impl Fn(&ParticipationFactor<T>) -> bool) -> T {
        let counted = self.factors.iter().filter(|factor| counts(factor));
        counted.fold(T::zero(), |sum, factor| sum + factor.value * factor.value)
    }
}

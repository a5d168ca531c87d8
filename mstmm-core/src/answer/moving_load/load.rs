//! A force of 1 that moves along a track: the modes and the influence line of an entry.

use crate::answer::modal::damping::{check_count, checked, damped_by};
use crate::answer::moving_load::wave_sum::WaveSum;
use crate::model::MotionError;
use crate::number::{List, Real};
use num_complex::Complex;
use num_traits::Zero;

/// A force of 1 N that moves along a straight chain of members, and an entry: the shapes of up to `N` modes along the `M` members, and the exact influence line.
///
/// The force acts across the members, along y of the first one: upwards, where that leads along x. On the earth multiply by the weight with its sign.
///
/// The entry is `Σ b_n q_n + I(x) - Σ b_n φ_n(x)/ω_n²`, with the force at x. The mode n with the value `b_n` of the entry has the coordinate `q_n` of
/// `q̈ + 2ζω q̇ + ω² q = φ_n(x)`. The influence line I is the deflection at rest under the load that works with the entry. So modes that are not in the list follow at
/// once, and a force that creeps has the influence line however short the list is. No bound is known for what the list leaves out besides: compare with twice as many modes.
///
/// A mode is exact at any time and speed, resonance included: its shape along a member is a sum of exponentials, and so is its integral with that of the mode.
///
/// ```
/// use mstmm_core::frame::{Frame, Section};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{FrameAnalysis, Support};
///
/// // a bridge of one span of 20 m, by its halves
/// let mut frame = Frame::new();
/// let [left, middle, right] = [0.0, 10.0, 20.0].map(|place| frame.point(place));
/// frame.hold(left, Support::Pinned);
/// frame.hold(right, Support::Pinned);
/// let section = Section::new().bending_stiffness(5e8).mass_per_length(1500.0);
/// let members = [frame.member(left, middle, section), frame.member(middle, right, section)];
/// let bridge = frame.build()?;
/// let roots = bridge.first_frequencies::<4>()?;
/// let load = bridge.moving_load::<4, _>(&roots, &members, middle.displacement_y())?;
/// // F l³/(48 EI) with the force at the middle
/// assert!((load.influence(10.0) / (20.0_f64.powi(3) / 48.0 / 5e8) - 1.0).abs() < 1e-12);
/// let crossing = load.with_damping_ratio(0.01)?.at_speed(30.0)?;
/// // 100 kN downwards, 0.4 s after they came
/// let deflection = -1e5 * crossing.after(0.4);
/// assert!(deflection < 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// The sum over modes: Frýba, Vibration of Solids and Structures under Moving Loads (1999), chapters 1 and 6. The influence line as the motion under a dislocation: Müller-Breslau.
#[derive(Clone, Copy, Debug)]
pub struct MovingLoad<T, const N: usize, const M: usize> {
    pub(super) modes: List<TrackMode<T, M>, N>,
    pub(super) line: [WaveSum<T>; M],
    pub(super) lengths: [T; M],
    /// How many roots were in the list.
    pub(crate) roots: usize,
}

/// A mode along a track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TrackMode<T, const M: usize> {
    omega: T,
    /// Its eigenvalue of the upper half plane.
    pub(super) lambda: Complex<T>,
    /// The entry.
    pub(super) entry: T,
    /// The place of its root in the list.
    root: usize,
    pub(super) shape: [WaveSum<T>; M],
    /// `∫ e^{λ(t-τ)} φ dτ` when the force leaves each member.
    pub(super) left: [Complex<T>; M],
}

impl<T: Real, const M: usize> Default for TrackMode<T, M> {
    fn default() -> Self {
        let (zero, none) = (T::zero(), Complex::zero());
        TrackMode { omega: zero, lambda: none, entry: zero, root: 0, shape: [WaveSum::default(); M], left: [none; M] }
    }
}

impl<T: Real, const M: usize> TrackMode<T, M> {
    /// A mode without damping.
    pub(crate) fn new(omega: T, root: usize, entry: T, shape: [WaveSum<T>; M]) -> Self {
        TrackMode { omega, lambda: Complex::new(T::zero(), omega), entry, root, shape, ..TrackMode::default() }
    }

    /// What a force at ξ of a member does to the entry at rest by the mode.
    fn at_rest(&self, member: usize, part: T) -> T {
        self.entry * self.shape[member].at(part) / (self.omega * self.omega)
    }
}

impl<T: Real, const N: usize, const M: usize> MovingLoad<T, N, M> {
    /// The load whose entry has an influence line along members of some lengths.
    pub(crate) fn new(line: [WaveSum<T>; M], lengths: [T; M]) -> Self {
        MovingLoad { modes: List::new(), line, lengths, roots: 0 }
    }

    /// Adds a mode of the root that comes next.
    pub(crate) fn push(&mut self, mode: TrackMode<T, M>) -> Result<(), MotionError> {
        self.modes.push(mode).map_err(|_| MotionError::Capacity { capacity: N })
    }

    /// The load with a damping ratio ζ in each mode.
    ///
    /// # Errors
    /// [`MotionError::DampingRatio`] for a ratio that is negative, or 1 and more.
    pub fn with_damping_ratio(&self, ratio: T) -> Result<Self, MotionError> {
        self.with_ratios(|_| ratio)
    }

    /// The load with a damping ratio for each root of the list, in its order.
    ///
    /// # Errors
    /// [`MotionError::DampingRatios`] for another number of ratios than roots; [`MotionError::DampingRatio`] for a ratio that is negative, or 1 and more.
    pub fn with_damping_ratios(&self, ratios: &[T]) -> Result<Self, MotionError> {
        check_count(ratios, self.roots)?;
        self.with_ratios(|root| ratios[root])
    }

    fn with_ratios(&self, ratio: impl Fn(usize) -> T) -> Result<Self, MotionError> {
        let mut damped = *self;
        for mode in damped.modes.as_mut_slice() {
            mode.lambda = damped_by(mode.omega, checked(ratio(mode.root))?);
        }
        Ok(damped)
    }

    /// The influence line: the entry at rest with a force of 1 at x \[m\] from the begin of the track; zero beyond the track, NaN for a place that is NaN. Where the line
    /// jumps, at the place of a shear force, it has the value before the jump.
    pub fn influence(&self, x: T) -> T {
        match self.member_at(x) {
            Place::Before | Place::Beyond => T::zero(),
            Place::On { member, part } => self.line[member].at(part),
            Place::Unknown => x,
        }
    }

    /// What modes that are not in the list have of a force at ξ of a member.
    pub(super) fn residual(&self, member: usize, part: T) -> T {
        let at_rest = self.line[member].at(part);
        self.modes.iter().fold(at_rest, |sum, mode| sum - mode.at_rest(member, part))
    }

    /// Where a place on the track is; a joint of two members belongs to the first one.
    pub(super) fn member_at(&self, x: T) -> Place<T> {
        if x < T::zero() {
            return Place::Before;
        }
        let mut begin = T::zero();
        for (member, length) in self.lengths.into_iter().enumerate() {
            if x <= begin + length {
                return Place::On { member, part: (x - begin) / length };
            }
            begin += length;
        }
        if x > begin { Place::Beyond } else { Place::Unknown }
    }

    /// The length of the track.
    pub(super) fn length(&self) -> T {
        self.lengths.into_iter().fold(T::zero(), |sum, length| sum + length)
    }
}

/// Where a place is.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place<T> {
    /// Before the track.
    Before,
    /// At ξ of a member.
    On { member: usize, part: T },
    /// Beyond the track.
    Beyond,
    /// A place that is NaN.
    Unknown,
}

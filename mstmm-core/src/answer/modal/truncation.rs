//! What a sum over modes leaves out, bounded.
//!
//! Of the modes n that are not in the list, a load works a_n on the mode and an entry of it is b_n. A sum with the residual compliance is exact at rest, so that at ω it leaves
//! out `Σ a_n b_n ω²/(ω_n² (ω_n² - ω²))`. All these modes are beyond the reach Ω, which a count proves. So for ω <= Ω
//!
//! - `ω²/(ω_n² - ω²) <= (ω/Ω)² Ω²/(ω_n² - Ω²)`, and by Cauchy and Schwarz the sum is at most `(ω/Ω)² √(R_aa R_bb)`, where
//!   `R_aa = Σ a_n² Ω²/(ω_n² (ω_n² - Ω²))`;
//! - `ω²/(ω_n² - ω²) <= ω²/(Ω² - ω²)`, and it is at most `ω²/(Ω² - ω²) √(ρ_aa ρ_bb)`, where `ρ_aa = Σ a_n²/ω_n²`.
//!
//! `R_aa` is the exact response at Ω of the entry that works with the load, less the sum of its listed modes and of their residual compliance, which is `ρ_aa`: two numbers of a
//! response at rest and one at Ω. Of an internal force b_n grows with ω_n² and `ρ_bb` is infinite, `R_bb` is not.
//!
//! In time a mode that a step sets off vibrates freely from its static value: it is at most that value away, whatever its ratio is. Under straight lines of a new slope each it
//! is away by at most `(1 + 2ζ)/ω_n` of the static value of the slope.
//!
//! Under a random load of the power spectrum G the root mean square σ is the norm of H with the weight G. So by the triangle inequality `|σ - σ_N| <= (∫ E² G df)^½`, where E is the
//! bound in frequency, if G has no power beyond the reach. Over a part of G up to ω₂ it is `E <= (ω/Ω)² √(R_aa R_bb)` and, since the fraction grows with ω,
//! `E <= ω²/(Ω² - ω₂²) √(ρ_aa ρ_bb)`. With damping ratios ζ of what is left out the term `2ζ(ω/Ω)√(..)` is added to either. So `E <= c ω² + d ω`, of which the mean square over the part is
//! a sum of moments of G in closed form. The parts are narrow for sharpness alone: each is bounded from above.

use crate::answer::modal::power_spectrum::PowerSpectrum;
use crate::answer::modal::response::{ModalResponse, Superposed};
use crate::model::{MotionError, TruncationError};
use crate::number::{Oscillation, Parameter, Real, RealFrequency, Scalar, smaller as least, turn};
use crate::search::{NaturalFrequencies, NaturalFrequency, Undamped};
use num_complex::Complex;
use num_traits::Zero;

/// Roundings of a response and of a sum of modes that a difference of both may have. They allow for responses and shapes that are rounded to one word; no bound of them is
/// known.
const ROUNDINGS: f64 = 64.0;

/// End of the first part of a spectrum that begins at zero, over the end of the spectrum.
const LOWEST_PART: f64 = 1.0 / 64.0;

/// End of a part of a spectrum over its start, over which a bound takes the larger value at the end: 16 per octave.
const WIDEST_PART: f64 = 1.044_273_782_427_413_8;

/// A bound for what a sum over modes leaves out, in frequency and in time.
///
/// It holds for all frequencies up to the reach, and it is attained: for the entry that works with the load itself, at the reach. It bounds what modes that are not in the list
/// do; rounding of the listed ones is beside it.
///
/// ```
/// use mstmm_core::frame::{Frame, Section};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{FrameAnalysis, Support};
///
/// let mut frame = Frame::new();
/// let [foot, tip] = [0.0, 2.0].map(|place| frame.point(place));
/// frame.hold(foot, Support::Fixed);
/// let beam = frame.member(foot, tip, Section::new().bending_stiffness(8.0).mass_per_length(1.5));
/// let cantilever = frame.build()?;
/// let roots = cantilever.frequencies(4)?;
/// let reach = 0.9 * roots[3].omega;
///
/// let (load, entry) = (tip.force_y(), beam.input().moment());
/// let sum = cantilever.modal_response::<3, _>(&roots[..3], load, entry)?;
/// let exact = cantilever.frequency_response(load, entry)?;
/// let truncation = cantilever.truncation::<3>(&roots[..3], load, entry, reach)?;
/// for part in [0.1, 0.5, 1.0] {
///     let omega = part * reach;
///     assert!((sum.at(omega)? - exact.at(omega)?).abs() <= truncation.at(omega));
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Truncation<T> {
    reach: T,
    load: Side<T>,
    entry: Side<T>,
}

/// What the modes that are not in the list have of a load, or of an entry.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side<T> {
    /// R, at the reach.
    at_reach: T,
    /// ρ, at rest; none where it is infinite.
    at_rest: Option<T>,
}

/// How much a record varies: what bounds of histories need of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation<T> {
    /// The first sample, by its size.
    pub first: T,
    /// The sum of all changes from sample to sample.
    pub total: T,
    /// The sum of all changes of the slope between samples, that of the begin among them.
    pub of_slope: T,
}

impl<T: Real> Side<T> {
    /// The side of a load and of the entry that works with it. Of an internal force no limit at rest is finite.
    pub(crate) fn new<'r, const N: usize>(
        source: &impl Superposed<T, NaturalFrequency<T>>,
        roots: impl IntoIterator<Item = &'r NaturalFrequency<T>> + Clone,
        reach: T,
        is_force: bool,
    ) -> Result<Self, MotionError>
    where
        T: Oscillation<T> + 'r,
    {
        let modes = ModalResponse::<T, N, RealFrequency>::new(source, roots.clone())?;
        let whole = source.exactly(reach)?;
        let (sum, size) = modes.sum_at(Complex::new(T::zero(), reach));
        let away = modes.away() / (reach * reach);
        let at_rest = modes.terms.iter().fold(modes.residual.size(), |sum, term| sum + term.at_rest().size());
        let rounding = ROUNDINGS * T::EPSILON;
        let left = |value: T, noise: f64| {
            let noise = T::from_f64(noise);
            if value > T::zero() { value + noise } else { noise }
        };
        let at_reach = whole - (sum.re + modes.residual - away);
        let noise = rounding * (at_rest + whole.size() + size + away.size()) + of_roots(&modes, roots, reach);
        let at_reach = left(at_reach, noise);
        // at a root of the list, or where numbers overflow
        if !at_reach.size().is_finite() {
            return Err(MotionError::Resonance { frequency: reach.to_f64() });
        }
        Ok(Side { at_reach, at_rest: (!is_force).then(|| left(modes.residual, rounding * at_rest)) })
    }

    /// `Σ a_n²/(ω_n² - Ω²)`.
    fn within_reach(&self) -> Option<T> {
        self.at_rest.map(|at_rest| at_rest + self.at_reach)
    }
}

impl<T: Real> Truncation<T> {
    pub(crate) fn new(reach: T, load: Side<T>, entry: Side<T>) -> Self {
        Truncation { reach, load, entry }
    }

    /// The largest error of the sum at a frequency ω [rad/s], without damping; infinite beyond the reach.
    pub fn at(&self, omega: T) -> T {
        let part = omega / self.reach;
        let square = part * part;
        // beyond the reach, or no number
        if square > T::one() || !square.size().is_finite() {
            return T::from_f64(f64::INFINITY);
        }
        let by_reach = square * (self.load.at_reach * self.entry.at_reach).sqrt();
        match self.at_rest() {
            Some(at_rest) if square < T::one() => {
                let by_rest = square / (T::one() - square) * at_rest;
                if by_rest < by_reach { by_rest } else { by_reach }
            }
            _ => by_reach,
        }
    }

    /// The largest error of the sum at a frequency ω [rad/s] where the modes that are not in the list have damping ratios up to `ratio`; none for an internal force under a
    /// dislocation, and for a negative ratio.
    pub fn at_with_ratio(&self, omega: T, ratio: T) -> Option<T> {
        if ratio < T::zero() || !ratio.size().is_finite() {
            return None;
        }
        Some(self.at(omega) + self.drag(ratio)? * omega.abs())
    }

    /// The largest error of [`to_step`](ModalResponse::to_step) at any time, for any damping ratios; none for internal forces.
    pub fn after_step(&self) -> Option<T> {
        self.at_rest()
    }

    /// The largest error of a history at any time, for damping ratios up to `ratio` of the modes that are not in the list; none for internal forces under a record that begins with
    /// a jump.
    pub fn over(&self, variation: Variation<T>, ratio: T) -> Option<T> {
        if ratio < T::zero() {
            return None;
        }
        let lag = (T::one() + ratio + ratio) / self.reach * variation.of_slope;
        let bound = match self.at_rest() {
            Some(at_rest) => {
                let changes = if lag < variation.total { lag } else { variation.total };
                at_rest * (variation.first + changes)
            }
            None if variation.first.is_zero() => {
                let by_load = self.load.at_rest.map(|at_rest| (at_rest * self.entry.at_reach).sqrt());
                let by_entry = self.entry.at_rest.map(|at_rest| (at_rest * self.load.at_reach).sqrt());
                smaller(by_load, by_entry)? * lag
            }
            None => return None,
        };
        // of samples that are no numbers there is none
        (bound >= T::zero()).then_some(bound)
    }

    /// The largest error of the root mean square that [`random`](ModalResponse::random) gives, for damping ratios up to `ratio` of the modes that are not in the list, whatever those of the
    /// list are, [`with_damping_ratio`](ModalResponse::with_damping_ratio) and its kin. None for a spectrum that reaches beyond the reach, such as white noise, for a negative ratio, and
    /// for an internal force under a dislocation with a ratio beyond zero.
    pub fn random(&self, spectrum: &PowerSpectrum<'_, T>, ratio: T) -> Option<T> {
        let highest = spectrum.ends()[1] * turn();
        if !(ratio >= T::zero() && ratio.size().is_finite() && highest <= self.reach) {
            return None;
        }
        spectrum.checked().ok()?;
        let drag = if ratio.is_zero() { T::zero() } else { self.drag(ratio)? };
        let of_reach = (self.load.at_reach * self.entry.at_reach).sqrt() / (self.reach * self.reach);
        let square = spectrum.pieces().fold(T::zero(), |sum, piece| {
            let [mut from, end] = piece.ends;
            let mut whole = sum;
            while from < end {
                let wide =
                    if from.is_zero() { end * T::from_f64(LOWEST_PART) } else { from * T::from_f64(WIDEST_PART) };
                let to = if wide > from { least(wide, end) } else { end };
                let omega = to * turn();
                let below = (self.reach - omega) * (self.reach + omega);
                let curve = self.at_rest().map_or(of_reach, |at_rest| least(at_rest / below, of_reach));
                // (c ω² + d ω)², times ω = 2π f
                let [c, d] = [curve * turn() * turn(), drag * turn()];
                let moment = |power| piece.moment([from, to], power);
                whole += c * c * moment(4) + (c + c) * d * moment(3) + d * d * moment(2);
                from = to;
            }
            whole
        });
        let bound = spectrum.root_of(square);
        // of numbers out of range there is none
        (bound >= T::zero() && bound.size().is_finite()).then_some(bound)
    }

    /// What damping ratios add to the bound in frequency, over ω.
    fn drag(&self, ratio: T) -> Option<T> {
        let mixed = |whole: Option<T>, other: T| whole.map(|whole| (whole * other).sqrt());
        let by_load = mixed(self.load.within_reach(), self.entry.at_reach);
        let by_entry = mixed(self.entry.within_reach(), self.load.at_reach);
        Some((ratio + ratio) / self.reach * smaller(by_load, by_entry)?)
    }

    /// `√(ρ_aa ρ_bb)`.
    fn at_rest(&self) -> Option<T> {
        Some((self.load.at_rest? * self.entry.at_rest?).sqrt())
    }
}

impl<T: Real> Variation<T> {
    /// The variation of a record in steps of `dt` \[s\], along straight lines between its samples. Slopes over a step that is not positive are infinite.
    pub fn of(record: &[T], dt: T) -> Self {
        let dt = if dt > T::zero() { dt } else { T::zero() };
        let first = record.first().map_or_else(T::zero, |sample| sample.abs());
        let (mut total, mut of_slope, mut before) = (T::zero(), T::zero(), T::zero());
        for pair in record.windows(2) {
            let change = pair[1] - pair[0];
            total += change.abs();
            if change != before {
                of_slope += ((change - before) / dt).abs();
            }
            before = change;
        }
        Variation { first, total, of_slope }
    }
}

/// The smaller one of two bounds that may not be there.
fn smaller<T: Real>(one: Option<T>, other: Option<T>) -> Option<T> {
    match (one, other) {
        (Some(one), Some(other)) => Some(if one < other { one } else { other }),
        (one, other) => one.or(other),
    }
}

/// By how much listed modes may be wrong at a reach, as far as their roots are known to their intervals: `a²/(ω² - Ω²)` changes by `2ω/|ω² - Ω²|` of itself with ω.
fn of_roots<'r, T: Real + 'r, const N: usize>(
    modes: &ModalResponse<T, N, RealFrequency>,
    roots: impl IntoIterator<Item = &'r NaturalFrequency<T>> + Clone,
    reach: T,
) -> f64 {
    modes.terms.iter().fold(0.0, |sum, term| {
        let Some(root) = roots.clone().into_iter().nth(term.root) else { return sum };
        let apart = (root.omega - reach).size() * (root.omega + reach).size();
        let known = (root.upper - root.lower).size() + 2.0 * T::EPSILON * root.omega.size();
        let part = (term.residue * term.lambda).re.size() / apart;
        sum + part * (2.0 * root.omega.size() * known / apart)
    })
}

/// Checks a reach, and that a list has all modes below it, one after the other from the first one on.
pub(crate) fn check_list<'r, Y>(
    system: &Y,
    roots: impl IntoIterator<Item = &'r NaturalFrequency<Y::Parameter>>,
    reach: Y::Parameter,
) -> Result<(), TruncationError>
where
    Y: NaturalFrequencies + Undamped,
    Y::Parameter: 'r,
{
    if !(reach > Y::Parameter::zero() && reach.size().is_finite()) {
        return Err(TruncationError::Reach { reach: reach.to_f64() });
    }
    let (counted, mut listed) = (system.count_below(reach)?, 0);
    for root in roots {
        if root.index != listed + 1 {
            return Err(TruncationError::Missing { counted, listed });
        }
        listed += root.multiplicity;
    }
    if counted == listed { Ok(()) } else { Err(TruncationError::Missing { counted, listed }) }
}

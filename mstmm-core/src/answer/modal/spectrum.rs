//! Peaks of responses by a response spectrum of the ground: the static part of each mode times its spectral acceleration.

use crate::answer::modal::response::ModalResponse;
use crate::model::SpectrumError;
use crate::number::{List, Real, logarithm, modulus};

/// A response spectrum: for an oscillator on the ground the largest deflection times the square of its frequency.
///
/// A closure of ω [rad/s] and the damping ratio, beside the largest acceleration of the ground itself, is one.
pub trait ResponseSpectrum<T> {
    /// The spectral acceleration [m/s²] of an oscillator of a frequency ω [rad/s] and a damping ratio.
    fn acceleration(&self, omega: T, ratio: T) -> T;

    /// That of what is rigid: the largest acceleration of the ground [m/s²].
    fn at_zero_period(&self) -> T;
}

impl<T: Copy, F: Fn(T, T) -> T> ResponseSpectrum<T> for (F, T) {
    fn acceleration(&self, omega: T, ratio: T) -> T {
        (self.0)(omega, ratio)
    }

    fn at_zero_period(&self) -> T {
        self.1
    }
}

/// A response spectrum as a table, straight between its rows on logarithmic scales and constant beyond its ends, whatever the damping ratio is.
///
/// ```
/// use mstmm_core::{ResponseSpectrum, SpectrumTable};
///
/// let table = SpectrumTable::hertz(&[(0.5, 2.0), (2.0, 6.0), (8.0, 6.0), (33.0, 2.4)])?;
/// let hertz = core::f64::consts::TAU;
/// // half way between 0.5 and 2 Hz on logarithmic scales
/// assert!((table.acceleration(1.0 * hertz, 0.05) - 12.0_f64.sqrt()).abs() < 1e-14);
/// assert_eq!(table.acceleration(100.0 * hertz, 0.05), 2.4);
/// assert_eq!(table.at_zero_period(), 2.4);
/// # Ok::<(), mstmm_core::SpectrumError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct SpectrumTable<'a, T> {
    rows: &'a [(T, T)],
    is_of_periods: bool,
    is_linear: bool,
}

impl<'a, T: Real> SpectrumTable<'a, T> {
    /// The spectrum of rows of a frequency \[Hz\] and an acceleration [m/s²].
    ///
    /// # Errors
    /// [`SpectrumError`] for a table without rows, or a row whose numbers cannot be.
    pub fn hertz(rows: &'a [(T, T)]) -> Result<Self, SpectrumError> {
        SpectrumTable { rows, is_of_periods: false, is_linear: false }.checked()
    }

    /// The spectrum of rows of a period \[s\] and an acceleration [m/s²].
    ///
    /// # Errors
    /// As [`hertz`](SpectrumTable::hertz).
    pub fn periods(rows: &'a [(T, T)]) -> Result<Self, SpectrumError> {
        SpectrumTable { rows, is_of_periods: true, is_linear: false }.checked()
    }

    /// The spectrum straight between its rows on linear scales.
    #[must_use]
    pub fn linear(self) -> Self {
        SpectrumTable { is_linear: true, ..self }
    }

    fn checked(self) -> Result<Self, SpectrumError> {
        if self.rows.is_empty() {
            return Err(SpectrumError::Empty);
        }
        let mut before = T::zero();
        for (row, (place, acceleration)) in self.rows.iter().enumerate() {
            if !(*place > before && place.size().is_finite()) {
                return Err(SpectrumError::Order { row });
            }
            if !(*acceleration > T::zero() && acceleration.size().is_finite()) {
                return Err(SpectrumError::Acceleration { acceleration: acceleration.to_f64() });
            }
            before = *place;
        }
        Ok(self)
    }

    /// The acceleration at a frequency \[Hz\], or at a period.
    fn at(&self, place: T) -> T {
        let above = self.rows.partition_point(|(own, _)| *own < place);
        let (Some(&(right, upper)), Some(&(left, lower))) =
            (self.rows.get(above), above.checked_sub(1).and_then(|below| self.rows.get(below)))
        else {
            return self.rows[above.min(self.rows.len() - 1)].1;
        };
        if self.is_linear {
            return lower + (upper - lower) * ((place - left) / (right - left));
        }
        let logarithm = |ratio: T| logarithm(ratio.to_f64());
        let slope = logarithm(upper / lower) / logarithm(right / left);
        lower * T::from_f64(slope * logarithm(place / left)).exp()
    }
}

impl<T: Real> ResponseSpectrum<T> for SpectrumTable<'_, T> {
    fn acceleration(&self, omega: T, _ratio: T) -> T {
        let turn = T::from_f64(core::f64::consts::TAU);
        self.at(if self.is_of_periods { turn / omega } else { omega / turn })
    }

    fn at_zero_period(&self) -> T {
        let rigid = if self.is_of_periods { self.rows.first() } else { self.rows.last() };
        rigid.map_or_else(T::zero, |(_, acceleration)| *acceleration)
    }
}

/// How peaks of modes become one peak.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// The root of the sum of squares, SRSS: for modes far apart.
    SumOfSquares,
    /// The complete quadratic combination, CQC: with the correlation of modes that are close to each other.
    CompleteQuadratic,
    /// The sum of all peaks: nothing is larger.
    AbsoluteSum,
}

/// How peaks of directions become one peak.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Directions {
    /// The root of the sum of squares.
    SumOfSquares,
    /// One of them whole and 30 % of all others, for each in turn.
    HundredThirty,
}

/// The peak of a response by a spectrum, mode by mode.
#[derive(Clone, Copy, Debug)]
pub struct SpectralPeak<T, const N: usize> {
    modes: List<PeakOfMode<T>, N>,
    /// The part of all modes that are not in the list, which move as what is rigid.
    pub missing: T,
    combination: Combination,
}

/// The peak of a root.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PeakOfMode<T> {
    /// The place of the root in the list.
    pub root: usize,
    /// Its frequency [rad/s].
    pub omega: T,
    /// Its damping ratio.
    pub ratio: T,
    /// Its peak, with the sign of its static part.
    pub value: T,
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The peak of the response by a spectrum of the ground: of each root the static part times the spectral acceleration, of several shapes together. What is not
    /// in the list moves as what is rigid does. A response without damping asks the spectrum for a ratio of zero, and its modes have no correlation; of complex modes, of dashpots, the
    /// static parts count alone.
    ///
    /// # Errors
    /// [`SpectrumError::NotRelative`] for another load than `base_acceleration`, for `absolute` and for a rate; [`SpectrumError::NoVibration`] for a rigid body and for what is
    /// damped beyond the critical; [`SpectrumError::Acceleration`] for an answer of the spectrum that is none.
    pub fn spectral_peak(
        &self,
        spectrum: &impl ResponseSpectrum<T>,
        combination: Combination,
    ) -> Result<SpectralPeak<T, N>, SpectrumError> {
        if self.facts.along.is_none() || !self.carried.is_zero() || self.facts.is_derived {
            return Err(SpectrumError::NotRelative);
        }
        if !self.rigid.is_zero() {
            return Err(SpectrumError::NoVibration { root: 0.0 });
        }
        let checked = |acceleration: T| {
            let is_one = acceleration >= T::zero() && acceleration.size().is_finite();
            is_one.then_some(acceleration).ok_or(SpectrumError::Acceleration { acceleration: acceleration.to_f64() })
        };
        let mut modes: List<PeakOfMode<T>, N> = List::new();
        for term in &self.terms {
            let omega = modulus(term.lambda);
            if term.lambda.im.is_zero() {
                return Err(SpectrumError::NoVibration { root: omega.to_f64() });
            }
            let at_rest = term.at_rest();
            match modes.as_mut_slice().iter_mut().find(|mode| mode.root == term.root) {
                Some(mode) => mode.value += at_rest,
                None => {
                    let ratio = -(term.lambda.re / omega);
                    let own = PeakOfMode { root: term.root, omega, ratio, value: at_rest };
                    // there are as many roots as terms, or fewer
                    modes.push(own).map_err(|_| SpectrumError::NotRelative)?;
                }
            }
        }
        for mode in modes.as_mut_slice() {
            mode.value *= checked(spectrum.acceleration(mode.omega, mode.ratio))?;
        }
        let missing = self.residual * checked(spectrum.at_zero_period())?;
        Ok(SpectralPeak { modes, missing, combination })
    }
}

impl<T: Real, const N: usize> SpectralPeak<T, N> {
    /// The peak of each root.
    pub fn modes(&self) -> &[PeakOfMode<T>] {
        &self.modes
    }

    /// The peak of all modes of the list.
    pub fn of_modes(&self) -> T {
        let modes = || self.modes.iter();
        match self.combination {
            Combination::AbsoluteSum => modes().fold(T::zero(), |sum, mode| sum + mode.value.abs()),
            Combination::SumOfSquares => modes().fold(T::zero(), |sum, mode| sum + mode.value * mode.value).sqrt(),
            Combination::CompleteQuadratic => {
                let with = |one: &PeakOfMode<T>| {
                    modes().fold(T::zero(), |sum, other| sum + correlation(one, other) * one.value * other.value)
                };
                let sum = modes().fold(T::zero(), |sum, one| sum + with(one));
                // a quadratic form of correlations is negative by rounding alone
                if sum > T::zero() { sum.sqrt() } else { T::zero() }
            }
        }
    }

    /// The peak of all modes. The part of modes that are not in the list adds by its square; in an `AbsoluteSum` it adds by its size.
    pub fn total(&self) -> T {
        let modes = self.of_modes();
        match self.combination {
            Combination::AbsoluteSum => modes + self.missing.abs(),
            _ => (modes * modes + self.missing * self.missing).sqrt(),
        }
    }
}

/// The correlation of two modes under white noise.
///
/// # Source
/// Der Kiureghian, A response spectrum method for random vibration analysis of MDF systems, 1981.
fn correlation<T: Real>(one: &PeakOfMode<T>, other: &PeakOfMode<T>) -> T {
    let number = T::from_f64;
    let x = other.omega / one.omega;
    let (first, second) = (one.ratio, other.ratio);
    let apart = (T::one() - x) * (T::one() + x);
    let below = apart * apart
        + number(4.0) * first * second * x * (T::one() + x * x)
        + number(4.0) * (first * first + second * second) * x * x;
    if below.is_zero() {
        return T::one();
    }
    number(8.0) * (first * second).sqrt() * (first + x * second) * x * x.sqrt() / below
}

/// The peak of several directions of the ground together.
pub fn combined<T: Real>(peaks: &[T], directions: Directions) -> T {
    let sum = peaks.iter().fold(T::zero(), |sum, peak| sum + peak.abs());
    match directions {
        Directions::SumOfSquares => peaks.iter().fold(T::zero(), |sum, peak| sum + *peak * *peak).sqrt(),
        Directions::HundredThirty => {
            let part = T::from_f64(0.3);
            let whole = peaks.iter().map(|peak| peak.abs() + (sum - peak.abs()) * part);
            whole.fold(T::zero(), |most, peak| if peak > most { peak } else { most })
        }
    }
}

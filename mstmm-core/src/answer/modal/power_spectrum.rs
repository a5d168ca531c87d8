//! Power spectra of loads, straight between their rows on logarithmic scales.

use crate::model::RandomError;
use crate::number::{Real, larger, logarithm_of_ratio, phi_1};
use num_complex::Complex;

/// The power spectrum of a load: its mean square per hertz, over frequencies of 0 and above alone (*one-sided*). Of an acceleration of the ground it is its acceleration
/// spectral density.
///
/// A table is straight between its rows on logarithmic scales, and has nothing beyond its ends.
///
/// ```
/// use mstmm_core::PowerSpectrum;
///
/// // in g²/Hz; 6 dB per octave up to 50 Hz
/// let rows = [(20.0, 0.026), (50.0, 0.16), (800.0, 0.16), (2000.0, 0.026)];
/// let shaker = PowerSpectrum::hertz(&rows)?;
/// assert!((shaker.rms() - 14.1_f64).abs() < 0.05);
/// assert_eq!(shaker.at(300.0), 0.16);
/// assert_eq!(shaker.at(19.0), 0.0);
///
/// // in (m/s²)²/Hz
/// let g = 9.80665;
/// assert!((shaker.times(g * g).rms() / g - shaker.rms()).abs() < 1e-13);
/// # Ok::<(), mstmm_core::RandomError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PowerSpectrum<'a, T> {
    shape: Shape<'a, T>,
    factor: T,
}

/// What a spectrum is made of; its numbers are those of the user.
#[derive(Clone, Copy, Debug)]
enum Shape<'a, T> {
    Rows(&'a [(T, T)]),
    Band { start: T, end: T, level: T },
    White { level: T },
}

/// A part of a spectrum between two rows: `level (f/anchor)^slope`, with the larger level of both ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece<T> {
    /// Both ends \[Hz\].
    pub(crate) ends: [T; 2],
    anchor: T,
    /// Over another level, such as the largest one.
    level: T,
    pub(crate) slope: T,
}

impl<'a, T: Real> PowerSpectrum<'a, T> {
    /// The spectrum of rows of a frequency \[Hz\] and a level, which is the square of the unit of the load per hertz.
    ///
    /// # Errors
    /// [`RandomError::Rows`] for fewer than two rows; [`RandomError::Order`] for frequencies that do not grow from row to row, or are not positive and finite;
    /// [`RandomError::Level`] for a level that is not positive and finite; [`RandomError::Steep`] for a row too close behind the one before. A step is two rows close to each other,
    /// such as a millionth of their frequency.
    pub fn hertz(rows: &'a [(T, T)]) -> Result<Self, RandomError> {
        if rows.len() < 2 {
            return Err(RandomError::Rows { rows: rows.len() });
        }
        let mut before = None;
        for (row, (hertz, level)) in rows.iter().enumerate() {
            let lowest = before.unwrap_or(T::zero());
            if !(*hertz > lowest && hertz.size().is_finite()) {
                return Err(RandomError::Order { row });
            }
            positive(*level)?;
            before = Some(*hertz);
        }
        let spectrum = PowerSpectrum { shape: Shape::Rows(rows), factor: T::one() };
        let is_steep = |piece: Piece<T>| piece.slope.size() >= STEEPEST / T::EPSILON;
        match spectrum.pieces().position(is_steep) {
            Some(piece) => Err(RandomError::Steep { row: piece + 1 }),
            None => Ok(spectrum),
        }
    }

    /// The spectrum of one level over a range of frequencies \[Hz\], which may begin at 0.
    ///
    /// # Errors
    /// [`RandomError::Band`] for a range that is empty, reversed, negative or not finite; [`RandomError::Level`] for a level that is not positive and finite.
    pub fn band(range: core::ops::RangeInclusive<T>, level: T) -> Result<Self, RandomError> {
        let (start, end) = range.into_inner();
        if !(start >= T::zero() && end > start && end.size().is_finite()) {
            return Err(RandomError::Band { start: start.to_f64(), end: end.to_f64() });
        }
        positive(level)?;
        Ok(PowerSpectrum { shape: Shape::Band { start, end, level }, factor: T::one() })
    }

    /// White noise: one level at all frequencies. A two-sided density S per rad/s is a level of `4π S`.
    pub fn white(level: T) -> Self {
        PowerSpectrum { shape: Shape::White { level }, factor: T::one() }
    }

    /// The spectrum times a factor, such as `g * g` from g² to (m/s²)².
    #[must_use]
    pub fn times(self, factor: T) -> Self {
        PowerSpectrum { factor: self.factor * factor, ..self }
    }

    /// The level at a frequency \[Hz\]; zero beyond its ends.
    pub fn at(&self, hertz: T) -> T {
        if let Shape::White { level } = self.shape {
            return if hertz >= T::zero() { level * self.factor } else { T::zero() };
        }
        let number = match self.shape {
            Shape::Rows(rows) => rows.partition_point(|(row, _)| *row < hertz).saturating_sub(1),
            Shape::Band { .. } | Shape::White { .. } => 0,
        };
        let piece = self.shape.piece(number, T::one());
        let own = piece.filter(|piece| hertz >= piece.ends[0] && hertz <= piece.ends[1]);
        own.map_or(T::zero(), |piece| piece.at(hertz) * self.factor)
    }

    /// The root mean square of the load: the root of the area below the spectrum. That of white noise is infinite; a factor that is negative has none, and it is no number.
    pub fn rms(&self) -> T {
        if self.is_white() {
            return T::from_f64(f64::INFINITY);
        }
        let sum = self.pieces().fold(T::zero(), |sum, piece| sum + piece.moment(piece.ends, 0));
        self.root_of(sum)
    }

    pub(crate) fn is_white(&self) -> bool {
        matches!(self.shape, Shape::White { .. })
    }

    /// Checks what [`white`](PowerSpectrum::white) and [`times`](PowerSpectrum::times) took unchecked.
    ///
    /// # Errors
    /// [`RandomError::Level`] for a level or a factor that is not positive and finite.
    pub(crate) fn checked(&self) -> Result<(), RandomError> {
        positive(self.largest())?;
        positive(self.factor)
    }

    /// The root of an integral over levels relative to the largest one.
    pub(crate) fn root_of(&self, integral: T) -> T {
        integral.sqrt() * self.largest().sqrt() * self.factor.sqrt()
    }

    /// The largest level, without the factor.
    fn largest(&self) -> T {
        match self.shape {
            Shape::Rows(rows) => rows.iter().fold(T::zero(), |most, (_, level)| larger(*level, most)),
            Shape::Band { level, .. } | Shape::White { level } => level,
        }
    }

    /// Its lowest and its highest frequency \[Hz\].
    pub(crate) fn ends(&self) -> [T; 2] {
        match self.shape {
            Shape::Rows([(start, _), .., (end, _)]) => [*start, *end],
            Shape::Band { start, end, .. } => [start, end],
            Shape::Rows(_) | Shape::White { .. } => [T::zero(), T::from_f64(f64::INFINITY)],
        }
    }

    /// The parts between rows; of white noise none.
    pub(crate) fn pieces(&self) -> impl Iterator<Item = Piece<T>> {
        let (shape, largest) = (self.shape, self.largest());
        (0..).map_while(move |number| shape.piece(number, largest))
    }
}

impl<T: Real> Shape<'_, T> {
    /// A part between two rows, its level over another one.
    fn piece(&self, number: usize, largest: T) -> Option<Piece<T>> {
        match *self {
            Shape::Rows(rows) => {
                let (start, end) = (rows.get(number)?, rows.get(number + 1)?);
                let slope = logarithm_of_ratio(end.1, start.1) / logarithm_of_ratio(end.0, start.0);
                let (anchor, level) = if end.1 > start.1 { *end } else { *start };
                Some(Piece { ends: [start.0, end.0], anchor, level: level / largest, slope })
            }
            Shape::Band { start, end, level } if number == 0 => {
                Some(Piece { ends: [start, end], anchor: end, level: level / largest, slope: T::zero() })
            }
            Shape::Band { .. } | Shape::White { .. } => None,
        }
    }
}

/// Steepest slope, times the rounding of a number, over which numbers still tell steps of the fourth part of an octave of its level.
const STEEPEST: f64 = 1.0 / 64.0;

/// Checks a level.
fn positive<T: Real>(level: T) -> Result<(), RandomError> {
    let is_one = level > T::zero() && level.size().is_finite();
    is_one.then_some(()).ok_or(RandomError::Level { level: level.to_f64() })
}

impl<T: Real> Piece<T> {
    /// The level at a frequency \[Hz\], over the other one.
    pub(crate) fn at(&self, hertz: T) -> T {
        if self.slope.is_zero() {
            return self.level;
        }
        self.level * (self.slope * logarithm_of_ratio(hertz, self.anchor)).exp()
    }

    /// `∫ f^power G df` between two frequencies of the piece: with `L = ln(f₂/f₁)` it is `f^(power + 1) G` at one end times `L φ₁(±(slope + power + 1) L)`. It is taken from the end
    /// where the integrand over a logarithmic scale is larger, so that nothing overflows, and no exponent is a case of its own.
    pub(crate) fn moment(&self, [start, end]: [T; 2], power: u16) -> T {
        let count = T::from_f64(f64::from(power) + 1.0);
        let raised = |hertz: T| (0..=power).fold(T::one(), |product, _| product * hertz);
        if start.is_zero() {
            return self.level * raised(end) / count;
        }
        let width = logarithm_of_ratio(end, start);
        let growth = (self.slope + count) * width;
        let (from, exponent) = if growth > T::zero() { (end, -growth) } else { (start, growth) };
        self.at(from) * raised(from) * width * phi_1(Complex::from(exponent)).re
    }
}

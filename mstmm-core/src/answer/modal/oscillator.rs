//! Peaks of an oscillator on a ground that moves by a record: the spectrum of a record, point by point.
//!
//! Between samples the acceleration of the ground runs linearly, and each quantity of the oscillator is `k₀ + k₁ t + Re(w e^{λt})`. Its rate has a zero at most between two
//! zeros of the rate of that, which are known: no extreme is missed, however long the steps are.

use crate::model::SpectrumError;
use crate::number::{Real, Size, argument, exponential};
use num_complex::Complex;
use num_traits::Zero;

/// Steps of Newton's method, each of which doubles the digits, and of the halves that it may need before.
const MOST_STEPS: usize = 80;

/// Vibrations of an oscillator in a step of a record, each of which is looked at: a limit of time alone.
const MOST_VIBRATIONS: f64 = 1e6;

/// The largest values of an oscillator on a ground that moves, by their sizes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OscillatorPeak<T> {
    /// The deflection relative to the ground \[m\]; times ω² it is the spectral acceleration.
    pub deflection: T,
    /// The velocity relative to the ground [m/s].
    pub velocity: T,
    /// The acceleration in space [m/s²].
    pub absolute_acceleration: T,
    /// The time of the largest deflection \[s\].
    pub time: T,
}

/// The peaks of an oscillator of a frequency ω [rad/s] and a damping ratio on a ground that moves by a record of accelerations [m/s²] in steps of `dt` \[s\], from rest at the
/// first sample up to the last one. For what vibrates on, append samples of zero.
///
/// They are exact for straight lines between the samples, beside rounding.
///
/// ```
/// use mstmm_core::oscillator_peak;
///
/// // a ground that is accelerated at once and goes on so: twice the static deflection, half a period later
/// let peak = oscillator_peak(&[3.0_f64; 60], 0.01, 10.0, 0.0)?;
/// assert!((peak.deflection - 2.0 * 3.0 / 100.0).abs() < 1e-16);
/// assert!((peak.time - core::f64::consts::PI / 10.0).abs() < 1e-12);
/// # Ok::<(), mstmm_core::SpectrumError>(())
/// ```
///
/// # Errors
/// [`SpectrumError::Oscillator`], [`SpectrumError::TimeStep`] and [`SpectrumError::Sample`] for numbers that cannot be; [`SpectrumError::Stiff`] for more than a million
/// vibrations in a step.
pub fn oscillator_peak<T: Real>(record: &[T], dt: T, omega: T, ratio: T) -> Result<OscillatorPeak<T>, SpectrumError> {
    let is_finite = |number: T| number.size().is_finite();
    if !(omega > T::zero() && is_finite(omega) && ratio >= T::zero() && ratio < T::one()) {
        return Err(SpectrumError::Oscillator { omega: omega.to_f64(), ratio: ratio.to_f64() });
    }
    if !(dt > T::zero() && is_finite(dt)) {
        return Err(SpectrumError::TimeStep { step: dt.to_f64() });
    }
    if omega.to_f64() * dt.to_f64() > MOST_VIBRATIONS * core::f64::consts::TAU {
        return Err(SpectrumError::Stiff { omega: omega.to_f64(), step: dt.to_f64() });
    }
    if let Some(sample) = record.iter().position(|sample| !is_finite(*sample)) {
        return Err(SpectrumError::Sample { sample });
    }
    let slowed = omega * ((T::one() - ratio) * (T::one() + ratio)).sqrt();
    let oscillator =
        Oscillator { omega, drag: (ratio + ratio) * omega, lambda: Complex::new(-(ratio * omega), slowed) };
    let (mut peak, mut state, mut start) = (OscillatorPeak::default(), [T::zero(); 2], T::zero());
    for pair in record.windows(2) {
        let [deflection, velocity, acceleration] = oscillator.within(state, [-pair[0], -pair[1]], dt);
        let (size, time) = deflection.largest(oscillator.lambda, dt);
        if size > peak.deflection {
            (peak.deflection, peak.time) = (size, start + time);
        }
        for (most, quantity) in [(&mut peak.velocity, &velocity), (&mut peak.absolute_acceleration, &acceleration)] {
            let (size, _) = quantity.largest(oscillator.lambda, dt);
            if size > *most {
                *most = size;
            }
        }
        state = [deflection, velocity].map(|quantity| quantity.at(oscillator.lambda, dt));
        start += dt;
    }
    Ok(peak)
}

/// The spectrum of a record: the peaks of oscillators of some frequencies ω [rad/s] and a damping ratio, as [`oscillator_peak`] gives them.
///
/// # Errors
/// As [`oscillator_peak`].
#[cfg(feature = "std")]
pub fn record_spectrum<T: Real>(
    record: &[T],
    dt: T,
    frequencies: impl IntoIterator<Item = T>,
    ratio: T,
) -> Result<std::vec::Vec<OscillatorPeak<T>>, SpectrumError> {
    frequencies.into_iter().map(|omega| oscillator_peak(record, dt, omega, ratio)).collect()
}

/// `ü + 2ζω u̇ + ω² u = f`.
struct Oscillator<T> {
    omega: T,
    drag: T,
    lambda: Complex<T>,
}

/// A quantity within a step: `k₀ + k₁ t + Re(w e^{λt})`.
struct Quantity<T> {
    constant: T,
    slope: T,
    wave: Complex<T>,
}

impl<T: Real> Oscillator<T> {
    /// Deflection, velocity and acceleration in space in a step that begins with a deflection and a velocity, under a force from one value to another.
    fn within(&self, [deflection, velocity]: [T; 2], [before, after]: [T; 2], dt: T) -> [Quantity<T>; 3] {
        let square = self.omega * self.omega;
        let slope = (after - before) / dt / square;
        let constant = (before - self.drag * slope) / square;
        let re = deflection - constant;
        let im = (self.lambda.re * re - (velocity - slope)) / self.lambda.im;
        let wave = Complex::new(re, im);
        // in space it is what spring and dashpot do
        let stiff = Complex::from(square) + self.lambda * self.drag;
        [
            Quantity { constant, slope, wave },
            Quantity { constant: slope, slope: T::zero(), wave: wave * self.lambda },
            Quantity {
                constant: -(square * constant + self.drag * slope),
                slope: -(square * slope),
                wave: -(wave * stiff),
            },
        ]
    }
}

impl<T: Real> Quantity<T> {
    fn at(&self, lambda: Complex<T>, time: T) -> T {
        self.constant + self.slope * time + (self.wave * exponential(lambda * time)).re
    }

    /// The rate of the quantity.
    fn rate(&self, lambda: Complex<T>) -> Self {
        Quantity { constant: self.slope, slope: T::zero(), wave: self.wave * lambda }
    }

    /// The largest size within a step, and when.
    fn largest(&self, lambda: Complex<T>, dt: T) -> (T, T) {
        let rate = self.rate(lambda);
        let curvature = rate.rate(lambda);
        let mut most = (T::zero(), T::zero());
        let mut take = |time: T| {
            let size = self.at(lambda, time).abs();
            if size > most.0 {
                most = (size, time);
            }
        };
        take(T::zero());
        take(dt);
        let mut from = T::zero();
        while from < dt {
            let to = curvature.next_zero(lambda, from, dt);
            if let Some(time) = rate.zero_between(lambda, &curvature, [from, to]) {
                take(time);
            }
            from = to;
        }
        most
    }

    /// The first zero of `Re(w e^{λt})` behind a time, at most the end.
    fn next_zero(&self, lambda: Complex<T>, from: T, end: T) -> T {
        if self.wave.is_zero() {
            return end;
        }
        let half = core::f64::consts::PI;
        let phase = argument(self.wave.re.to_f64(), self.wave.im.to_f64());
        let (rate, now) = (lambda.im.to_f64(), from.to_f64());
        // phase + ω t = π/2 + kπ, for the first k behind the time, which is -1 at least
        let turns = (phase + rate * now) / half - 0.5;
        let next = (turns + 2.0).whole().0 - 1.0;
        let zero = T::from_f64(((next + 0.5) * half - phase) / rate);
        if zero > from && zero < end {
            zero
        } else if zero >= end {
            end
        } else {
            // rounding has put it at the time itself
            let later = T::from_f64(((next + 1.5) * half - phase) / rate);
            if later < end { later } else { end }
        }
    }

    /// The zero between two times, between which the quantity is monotone, if it changes its sign.
    fn zero_between(&self, lambda: Complex<T>, rate: &Self, [mut from, mut to]: [T; 2]) -> Option<T> {
        let (first, last) = (self.at(lambda, from), self.at(lambda, to));
        let rises = first < T::zero();
        if first.is_zero() || last.is_zero() || rises == (last < T::zero()) {
            return None;
        }
        let half = T::from_f64(0.5);
        let mut time = (from + to) * half;
        for _ in 0..MOST_STEPS {
            let value = self.at(lambda, time);
            if value.is_zero() {
                return Some(time);
            }
            if (value < T::zero()) == rises {
                from = time
            } else {
                to = time
            }
            let step = value / rate.at(lambda, time);
            let newton = time - step;
            let next = if newton > from && newton < to { newton } else { (from + to) * half };
            if (next - time).size() <= T::EPSILON * to.size() {
                return Some(next);
            }
            time = next;
        }
        Some(time)
    }
}

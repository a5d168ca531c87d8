//! Peaks of an oscillator on a ground that moves by a record: the spectrum of a record, point by point.
//!
//! Between samples the acceleration of the ground runs linearly. The second rate of each quantity of the oscillator is a wave `Re(w e^{λt})`, whose zeros are known. Between two of
//! them its rate has a zero at most: no extreme is missed, however long the steps are.

use crate::model::SpectrumError;
use crate::number::{Real, Size, argument, exponential, phi_1, phi_2};
use num_complex::Complex;
use num_traits::Zero;

/// Steps of Newton's method, each of which doubles the digits, and of the halves that it may need before.
const MOST_STEPS: usize = 80;

/// Vibrations of an oscillator in a record, each of which is looked at: a limit of time alone.
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
/// vibrations in the record; [`SpectrumError::Overflow`] where numbers overflow.
pub fn oscillator_peak<T: Real>(record: &[T], dt: T, omega: T, ratio: T) -> Result<OscillatorPeak<T>, SpectrumError> {
    let is_finite = |number: T| number.size().is_finite();
    if !(omega > T::zero() && is_finite(omega) && ratio >= T::zero() && ratio < T::one()) {
        return Err(SpectrumError::Oscillator { omega: omega.to_f64(), ratio: ratio.to_f64() });
    }
    if !(dt > T::zero() && is_finite(dt)) {
        return Err(SpectrumError::TimeStep { step: dt.to_f64() });
    }
    let vibrations = omega.to_f64() * dt.to_f64() * record.len() as f64 / core::f64::consts::TAU;
    if vibrations > MOST_VIBRATIONS {
        return Err(SpectrumError::Stiff { omega: omega.to_f64(), vibrations });
    }
    if let Some(sample) = record.iter().position(|sample| !is_finite(*sample)) {
        return Err(SpectrumError::Sample { sample });
    }
    let slowed = omega * ((T::one() - ratio) * (T::one() + ratio)).sqrt();
    let oscillator = Oscillator {
        square: omega * omega,
        drag: (ratio + ratio) * omega,
        lambda: Complex::new(-(ratio * omega), slowed),
    };
    let (mut peak, mut state, mut start) = (OscillatorPeak::default(), [T::zero(); 2], T::zero());
    for pair in record.windows(2) {
        let step = Step { oscillator: &oscillator, state, force: -pair[0], slope: (pair[0] - pair[1]) / dt };
        let [deflection, velocity, acceleration] = step.largest(dt);
        if deflection.0 > peak.deflection {
            (peak.deflection, peak.time) = (deflection.0, start + deflection.1);
        }
        for (most, (size, _)) in [(&mut peak.velocity, velocity), (&mut peak.absolute_acceleration, acceleration)] {
            if size > *most {
                *most = size;
            }
        }
        let at_end = step.motion(dt);
        if !at_end.iter().all(|number| is_finite(*number)) {
            return Err(SpectrumError::Overflow { omega: omega.to_f64(), time: (start + dt).to_f64() });
        }
        state = [at_end[0], at_end[1]];
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
    /// ω², and 2ζω.
    square: T,
    drag: T,
    lambda: Complex<T>,
}

/// A step of a record: deflection and velocity at its begin, and a force that runs straight.
struct Step<'a, T> {
    oscillator: &'a Oscillator<T>,
    state: [T; 2],
    force: T,
    slope: T,
}

impl<T: Real> Step<'_, T> {
    /// Deflection, velocity, its rate and the rate of that at a time of the step. What the force does from rest is `Im(t φ₁ f + t² φ₂ ḟ)/ω_d`, which cancels nothing where the
    /// oscillator is slow.
    fn motion(&self, time: T) -> [T; 4] {
        let Step { oscillator: Oscillator { square, drag, lambda }, state: [deflection, velocity], .. } = *self;
        let z = *lambda * time;
        let forced = phi_1(z) * (time * self.force) + phi_2(z) * (time * time * self.slope);
        let wave = Complex::new(deflection, (lambda.re * deflection - velocity) / lambda.im) * exponential(z);
        let force = self.force + self.slope * time;
        let deflection = wave.re + forced.im / lambda.im;
        let velocity = (*lambda * wave).re + (*lambda * forced).im / lambda.im;
        let rate = force - *drag * velocity - *square * deflection;
        [deflection, velocity, rate, self.slope - *drag * rate - *square * velocity]
    }

    /// Deflection, velocity and acceleration in space at a time, each with its rate and the rate of that.
    fn quantity(&self, of: usize, time: T) -> [T; 3] {
        let [deflection, velocity, rate, jerk] = self.motion(time);
        let Oscillator { square, drag, .. } = *self.oscillator;
        let in_space = |one: T, other: T| -(drag * one + square * other);
        match of {
            0 => [deflection, velocity, rate],
            1 => [velocity, rate, jerk],
            _ => [in_space(velocity, deflection), in_space(rate, velocity), in_space(jerk, rate)],
        }
    }

    /// The largest sizes of deflection, velocity and acceleration in space within the step, each with its time.
    fn largest(&self, dt: T) -> [(T, T); 3] {
        let Oscillator { square, drag, lambda } = *self.oscillator;
        // the rate of the velocity is Re(w e^{λt}), as are the second rates of all three
        let [_, _, rate, jerk] = self.motion(T::zero());
        let wave = Complex::new(rate, (lambda.re * rate - jerk) / lambda.im);
        [wave, wave * lambda, wave * (lambda * drag + Complex::from(square))].iter().enumerate().fold(
            [(T::zero(), T::zero()); 3],
            |mut most, (of, curvature)| {
                most[of] = self.largest_of(of, *curvature, dt);
                most
            },
        )
    }

    fn largest_of(&self, of: usize, curvature: Complex<T>, dt: T) -> (T, T) {
        let mut most = (T::zero(), T::zero());
        let mut take = |time: T| {
            let size = self.quantity(of, time)[0].abs();
            if size > most.0 {
                most = (size, time);
            }
        };
        take(T::zero());
        take(dt);
        let mut from = T::zero();
        while from < dt {
            let to = next_zero(curvature, self.oscillator.lambda.im, from, dt);
            if let Some(time) = self.extreme_between(of, [from, to]) {
                take(time);
            }
            from = to;
        }
        most
    }

    /// The time between two at which the rate of a quantity vanishes, if it changes its sign; it is monotone between them.
    fn extreme_between(&self, of: usize, [mut from, mut to]: [T; 2]) -> Option<T> {
        let [first, last] = [from, to].map(|time| self.quantity(of, time)[1]);
        let rises = first < T::zero();
        if first.is_zero() || last.is_zero() || rises == (last < T::zero()) {
            return None;
        }
        let half = T::from_f64(0.5);
        let mut time = (from + to) * half;
        for _ in 0..MOST_STEPS {
            let [_, rate, curvature] = self.quantity(of, time);
            if rate.is_zero() {
                return Some(time);
            }
            if (rate < T::zero()) == rises {
                from = time;
            } else {
                to = time;
            }
            let newton = time - rate / curvature;
            let next = if newton > from && newton < to { newton } else { (from + to) * half };
            if (next - time).size() <= T::EPSILON * to.size() {
                return Some(next);
            }
            time = next;
        }
        Some(time)
    }
}

/// The first zero of `Re(w e^{λt})` behind a time, given the imaginary part of λ; at most the end.
fn next_zero<T: Real>(wave: Complex<T>, frequency: T, from: T, end: T) -> T {
    if wave.is_zero() {
        return end;
    }
    let half = core::f64::consts::PI;
    let phase = argument(wave.re.to_f64(), wave.im.to_f64());
    let (rate, now) = (frequency.to_f64(), from.to_f64());
    // phase + ω t = π/2 + kπ, for the first k behind the time, which is -1 at least
    let turns = (phase + rate * now) / half - 0.5;
    let next = (turns + 2.0).whole().0 - 1.0;
    let of_turn = |turn: f64| T::from_f64(((turn + 0.5) * half - phase) / rate);
    let zero = of_turn(next);
    // rounding may have put it at the time itself
    let zero = if zero > from { zero } else { of_turn(next + 1.0) };
    if zero < end { zero } else { end }
}

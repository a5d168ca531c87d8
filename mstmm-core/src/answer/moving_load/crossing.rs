//! The crossing of a force at a speed.

use crate::answer::moving_load::load::{MovingLoad, Place, TrackMode};
use crate::model::TrackError;
use crate::number::{Real, exponential};
use num_complex::Complex;

/// A force of 1 N that moves along a track with a speed, from its begin at t = 0 on.
///
/// Its answers are closed forms: a time is as good as any other, and none needs another before it. [`MovingLoad`] says what is superposed.
///
/// ```
/// use mstmm_core::frame::{Frame, Section};
/// use mstmm_core::search::NaturalFrequencies;
/// use mstmm_core::{FrameAnalysis, Support};
///
/// let mut frame = Frame::new();
/// let [left, middle, right] = [0.0, 10.0, 20.0].map(|place| frame.point(place));
/// frame.hold(left, Support::Pinned);
/// frame.hold(right, Support::Pinned);
/// let section = Section::new().bending_stiffness(5e8).mass_per_length(1500.0);
/// let members = [frame.member(left, middle, section), frame.member(middle, right, section)];
/// let bridge = frame.build()?;
/// let roots = bridge.first_frequencies::<4>()?;
/// let crossing = bridge.moving_load::<4, _>(&roots, &members, middle.displacement_y())?.at_speed(30.0)?;
/// // two axles, of 60 and of 110 kN, 4 m apart
/// let axles = [(0.0, -60e3), (4.0, -110e3)];
/// let [lowest, highest] = crossing.envelope(&axles, 200);
/// let at_one_time = crossing.axles(&axles, 0.4);
/// assert!(lowest <= at_one_time && at_one_time < 0.0 && highest >= 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Crossing<T, const N: usize, const M: usize> {
    load: MovingLoad<T, N, M>,
    speed: T,
}

impl<T: Real, const N: usize, const M: usize> MovingLoad<T, N, M> {
    /// The load with a speed v [m/s].
    ///
    /// # Errors
    /// [`TrackError::Speed`] for a speed that is not positive or not finite.
    pub fn at_speed(&self, speed: T) -> Result<Crossing<T, N, M>, TrackError> {
        if !(speed > T::zero() && speed.size().is_finite()) {
            return Err(TrackError::Speed { speed: speed.to_f64() });
        }
        let mut load = *self;
        for mode in load.modes.as_mut_slice() {
            for member in 0..M {
                mode.left[member] = mode.driven(member, T::one(), speed / load.lengths[member]);
            }
        }
        Ok(Crossing { load, speed })
    }
}

impl<T: Real, const M: usize> TrackMode<T, M> {
    /// `∫ e^{λ(t-τ)} φ dτ` with the force at ξ of a member, which it passes so many times in a unit of time, given the same where it left the one before.
    fn driven(&self, member: usize, part: T, rate: T) -> Complex<T> {
        let along = self.lambda / rate;
        let own = self.shape[member].passed(part, along) / rate;
        let before = member.checked_sub(1).map(|before| self.left[before] * exponential(along * part));
        before.map_or(own, |before| before + own)
    }

    /// The entry, given that integral.
    fn entry_of(&self, integral: Complex<T>) -> T {
        self.entry * integral.im / self.lambda.im
    }
}

impl<T: Real, const N: usize, const M: usize> Crossing<T, N, M> {
    /// The entry at a time \[s\] after the force came; 0 before it, NaN for a time that is not finite. When the force has left, the modes vibrate freely.
    pub fn after(&self, time: T) -> T {
        let load = &self.load;
        match load.member_at(time * self.speed) {
            Place::Before => T::zero(),
            Place::On { member, part } => {
                let rate = self.speed / load.lengths[member];
                let of_modes = load.modes.iter().map(|mode| mode.entry_of(mode.driven(member, part, rate)));
                of_modes.fold(load.residual(member, part), |sum, own| sum + own)
            }
            Place::Beyond => {
                let since = time - load.length() / self.speed;
                load.modes.iter().fold(T::zero(), |sum, mode| {
                    let left = mode.left.last().map(|left| *left * exponential(mode.lambda * since));
                    sum + left.map_or(T::zero(), |left| mode.entry_of(left))
                })
            }
            Place::Unknown => time,
        }
    }

    /// The entry at a time \[s\] after the begin under several forces, each with its distance \[m\] behind the first one and its value \[N\]: the axles of a vehicle.
    pub fn axles(&self, axles: &[(T, T)], time: T) -> T {
        axles.iter().fold(T::zero(), |sum, (offset, force)| sum + *force * self.after(time - *offset / self.speed))
    }

    /// The least and the largest value of the entry while some of the axles are on the track, at the ends of `steps` equal steps of time, of which there is at least one.
    /// A peak between two of these times is not seen, nor one after the last axle has left. No axles give zeros.
    pub fn envelope(&self, axles: &[(T, T)], steps: usize) -> [T; 2] {
        let Some(((first, _), others)) = axles.split_first() else { return [T::zero(); 2] };
        let [front, rear] = others.iter().fold([*first; 2], |[front, rear], (offset, _)| {
            [if *offset < front { *offset } else { front }, if *offset > rear { *offset } else { rear }]
        });
        let steps = steps.max(1);
        let step = (rear - front + self.load.length()) / (self.speed * T::from_f64(steps as f64));
        let at = |k: usize| self.axles(axles, front / self.speed + step * T::from_f64(k as f64));
        let begin = at(0);
        (1..=steps).map(at).fold([begin; 2], |[least, largest], value| {
            // a value that is NaN stays: it is one at all times
            [if value < least { value } else { least }, if value > largest { value } else { largest }]
        })
    }

    /// The influence line, as [`MovingLoad::influence`] has it.
    pub fn influence(&self, x: T) -> T {
        self.load.influence(x)
    }

    /// The speed [m/s].
    pub fn speed(&self) -> T {
        self.speed
    }

    /// The time \[s\] that the force is on the track.
    pub fn duration(&self) -> T {
        self.load.length() / self.speed
    }
}

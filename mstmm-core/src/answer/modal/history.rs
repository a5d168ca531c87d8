//! Responses to force histories, sample by sample.

use crate::answer::modal::response::{ModalResponse, Term};
use crate::model::MotionError;
use crate::number::{List, Real, exponential, phi_1, phi_2};
use num_complex::Complex;
use num_traits::Zero;

/// The response to a force history, sample by sample, as a digital filter gives it.
///
/// Between samples the force runs linearly. For such a force every step is exact, however long compared with the periods of the
/// modes; there is no limit of stability. Modes that are not in the list follow the force at once.
#[derive(Clone, Copy, Debug)]
pub struct ForceHistory<T, const N: usize> {
    modes: List<Mode<T>, N>,
    rigid: Rigid<T>,
    residual: T,
    /// What follows the rate of the force at once.
    flow: T,
    /// The residual compliance in its place, where it is late.
    late: Option<Mode<T>>,
    /// The last sample of the force; none before the first.
    force: Option<T>,
}

/// An entry with its rate and its acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EntryMotion<T> {
    /// The entry.
    pub value: T,
    /// Its rate per second.
    pub rate: T,
    /// The rate of that. Modes that are not in the list have no part in it.
    pub acceleration: T,
}

/// A term of the response: `q̇ = λ q + residue · F`.
#[derive(Clone, Copy, Debug, Default)]
struct Mode<T> {
    value: Complex<T>,
    lambda: Complex<T>,
    residue: Complex<T>,
    /// `e^{λ dt}`
    growth: Complex<T>,
    /// The contributions to the end of a step of a unit force at its begin and of a unit force at its end.
    weights: [Complex<T>; 2],
}

/// The motion of all rigid bodies together.
#[derive(Clone, Copy, Debug)]
struct Rigid<T> {
    position: T,
    velocity: T,
    dt: T,
    /// The acceleration under a force of 1.
    acceleration: T,
}

impl<T: Real, const N: usize, M> ModalResponse<T, N, M> {
    /// The response to a force history in steps of `dt` \[s\], from rest.
    ///
    /// # Errors
    /// [`MotionError::TimeStep`] for a step that is not positive or not finite.
    pub fn history(&self, dt: T) -> Result<ForceHistory<T, N>, MotionError> {
        ForceHistory::new(self, dt)
    }
}

impl<T: Real, const N: usize> ForceHistory<T, N> {
    fn new<M>(response: &ModalResponse<T, N, M>, dt: T) -> Result<Self, MotionError> {
        if !(dt > T::zero() && dt.size().is_finite()) {
            return Err(MotionError::TimeStep { step: dt.to_f64() });
        }
        let mut modes = List::new();
        for term in &response.terms {
            modes.push(Mode::new(term, dt)).map_err(|_| MotionError::Capacity { capacity: N })?;
        }
        let rigid = Rigid { position: T::zero(), velocity: T::zero(), dt, acceleration: response.away() };
        let late = response.late().map(|term| Mode::new(&term, dt));
        let residual = if late.is_some() { T::zero() } else { response.residual };
        Ok(ForceHistory { modes, rigid, residual, flow: response.flow, late, force: None })
    }

    /// The history from rest under a force [N or N m], which was there before: with the same force as the first sample nothing moves, and one of 0 lets go.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where a rigid body moves off under the force, or drifts against a damper.
    pub fn under(mut self, force: T) -> Result<Self, MotionError> {
        if !self.rigid.acceleration.is_zero() || self.modes.iter().any(|mode| mode.lambda.is_zero()) {
            return Err(MotionError::Resonance { frequency: 0.0 });
        }
        for mode in self.modes.as_mut_slice().iter_mut().chain(&mut self.late) {
            mode.value = -(mode.residue / mode.lambda) * force;
        }
        Ok(ForceHistory { force: None, ..self })
    }

    /// Takes the next sample of the force [N or N m] and gives the entry at its time; the first is that of t = 0, where the
    /// system is at rest.
    pub fn next(&mut self, force: T) -> T {
        let slope = if self.flow.is_zero() { T::zero() } else { self.slope(force) };
        self.step(force);
        self.value(force, slope)
    }

    /// As [`next`](ForceHistory::next), with the rate of the entry and its acceleration. Where the force has a kink, the rates before it count; at the first sample
    /// the force has no rate yet.
    pub fn next_motion(&mut self, force: T) -> EntryMotion<T> {
        let slope = self.slope(force);
        self.step(force);
        let of_modes = self.modes.iter().chain(&self.late);
        let rate = of_modes.fold(self.rigid.velocity + self.residual * slope, |sum, mode| sum + mode.rate(force).re);
        let acceleration = self.modes.iter().fold(self.rigid.acceleration * force, |sum, mode| {
            sum + (mode.lambda * mode.rate(force) + mode.residue * slope).re
        });
        EntryMotion { value: self.value(force, slope), rate, acceleration }
    }

    /// The entry at all samples of a record, one after the other.
    #[cfg(feature = "std")]
    pub fn all(&mut self, record: &[T]) -> std::vec::Vec<T> {
        record.iter().map(|force| self.next(*force)).collect()
    }

    fn step(&mut self, force: T) {
        if let Some(before) = self.force.replace(force) {
            self.rigid.step(before, force);
            for mode in self.modes.as_mut_slice().iter_mut().chain(&mut self.late) {
                mode.step(before, force);
            }
        }
    }

    /// The entry under a force that has come with a slope.
    fn value(&self, force: T, slope: T) -> T {
        let of_modes = self.modes.iter().chain(&self.late);
        let at_once = self.rigid.position + self.residual * force + self.flow * slope;
        of_modes.fold(at_once, |sum, mode| sum + mode.value.re)
    }

    /// The slope of the force in the step that ends.
    fn slope(&self, force: T) -> T {
        self.force.map_or_else(T::zero, |before| (force - before) / self.rigid.dt)
    }
}

impl<T: Real> Mode<T> {
    fn new(term: &Term<T>, dt: T) -> Self {
        let z = term.lambda * dt;
        let (whole, end) = (phi_1(z), phi_2(z));
        let weights = [whole - end, end].map(|weight| term.residue * weight * dt);
        let Term { lambda, residue, .. } = *term;
        Mode { value: Complex::zero(), lambda, residue, growth: exponential(z), weights }
    }

    fn step(&mut self, before: T, after: T) {
        self.value = self.value * self.growth + self.weights[0] * before + self.weights[1] * after;
    }

    /// `q̇` under a force.
    fn rate(&self, force: T) -> Complex<T> {
        self.lambda * self.value + self.residue * force
    }
}

impl<T: Real> Rigid<T> {
    /// Closed form for a force that runs linearly.
    fn step(&mut self, before: T, after: T) {
        let (half, third) = (T::from_f64(0.5), T::one() / T::from_f64(3.0));
        let gain = self.acceleration * self.dt;
        self.position += self.dt * (self.velocity + gain * (before + after * half) * third);
        self.velocity += gain * (before + after) * half;
    }
}

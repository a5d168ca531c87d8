//! Responses to harmonic loads.

use super::error::MotionError;
use super::label::{Entry, Load};
use super::passes::Passes;
use super::tree::{Planned, Tree};
use crate::layout::{Scheme, Step};
use crate::scalar::Oscillation;
use crate::scaled::Scaled;
use crate::state::{Coordinate, Space};

/// A transfer function of a system: an entry of a state per harmonic load of 1.
#[derive(Debug)]
pub struct FrequencyResponse<'a, Y: Planned + ?Sized> {
    system: &'a Y,
    load: Place,
    entry: Place,
    /// Steps between the two, which alone are computed.
    between: Y::PerStep<bool>,
}

impl<Y: Planned + ?Sized> Clone for FrequencyResponse<'_, Y> {
    fn clone(&self) -> Self {
        FrequencyResponse { ..*self }
    }
}

/// An entry of the state behind a step.
#[derive(Clone, Copy, Debug)]
struct Place {
    step: usize,
    /// On the side of the step downstream of it.
    beyond: bool,
    coordinate: Coordinate,
}

impl Place {
    /// The entry at a point; at a connection that goes on to fewer states one of its inputs may have what it leaves behind.
    fn new(scheme: Scheme<'_>, step: usize, beyond: bool, coordinate: Coordinate) -> Result<Self, MotionError> {
        let has = |step: usize| {
            let space = scheme.behind(step);
            space.coordinates().contains(&coordinate) && !space.is(Space::Planar)
        };
        if has(step) {
            return Ok(Place { step, beyond, coordinate });
        }
        let inputs = if let Step::Connection(inputs) = scheme.steps[step] { inputs } else { &[] };
        let is_path = |input: &&usize| !matches!(scheme.steps[**input], Step::Tip(_));
        match inputs.iter().filter(is_path).find(|input| has(**input)) {
            Some(&step) => Ok(Place { step, beyond: false, coordinate }),
            None => Err(MotionError::NoSuchEntry { coordinate }),
        }
    }
}

impl<'a, Y: Planned + ?Sized> FrequencyResponse<'a, Y> {
    pub(super) fn new(system: &'a Y, load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let scheme = Y::scheme();
        let load = Place::new(scheme, load.point.step, false, load.coordinate)?;
        let entry = Place::new(scheme, entry.point.step, entry.point.beyond, entry.coordinate)?;
        let mut between = Y::per_step(false);
        for end in [load.step, entry.step] {
            let mut step = end;
            while !matches!(scheme.steps[step], Step::Root(..)) {
                between.as_mut()[step] ^= true;
                step = scheme.downstream(step);
            }
        }
        between.as_mut()[entry.step] = true;
        Ok(FrequencyResponse { system, load, entry, between })
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration. 0 is the static
    /// limit.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::NotFinite`] where the arithmetic overflows.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let frequency = x.size();
        let Place { step, coordinate, .. } = self.load;
        let mut passes = Passes::from_tips(self.system, x);
        passes.down_to(step);
        let delta = passes.delta(step);
        if delta.mantissa().is_zero() {
            return Err(MotionError::Resonance { frequency });
        }
        // a force acts towards Y, a moment towards Θ: Q grows by the one and M falls by the other
        let unit = if coordinate == Coordinate::M { -S::one() } else { S::one() };
        let factor = Scaled::new(unit, 0).over(delta);
        let exponent = factor.exponent().clamp(-1 << 30, 1 << 30) as i32;
        let jump = passes.jump(step, coordinate);
        let [upstream, downstream] =
            [jump.upstream, jump.downstream].map(|covector| covector.times(factor.mantissa(), exponent));
        let between = self.between.as_ref();
        let spread = passes.spread(step, upstream, downstream, |step| between[step]);
        let at_load = self.entry.beyond && self.entry.step == step;
        let state = if at_load { spread.beyond } else { spread.states.as_ref()[self.entry.step] };
        let value = state.shifted(0).entry(self.entry.coordinate);
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency }) }
    }

    /// The response on a grid of the caller's, into memory of the caller's.
    ///
    /// # Errors
    /// As [`at`](FrequencyResponse::at); [`MotionError::Capacity`] where `values` is shorter than `grid`.
    pub fn on<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        if values.len() < grid.len() {
            return Err(MotionError::Capacity { capacity: values.len() });
        }
        for (value, &x) in values.iter_mut().zip(grid) {
            *value = self.at(x)?;
        }
        Ok(())
    }
}

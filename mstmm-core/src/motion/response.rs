//! Responses to harmonic loads.

use super::covector::{Covector, ScaledState};
use super::error::MotionError;
use super::label::{Entry, Load};
use super::passes::Passes;
use super::spread::Wanted;
use super::tree::{Planned, Tree};
use crate::layout::{Scheme, Step};
use crate::scalar::{Oscillation, Scalar};
use crate::scaled::Scaled;
use crate::state::{Coordinate, Space, State};
use crate::subspace::Subspace;

/// A transfer function of a system: an entry of a state per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct FrequencyResponse<'a, Y: Planned + ?Sized> {
    system: &'a Y,
    load: Place,
    entry: Place,
    /// Steps between the two, whose states alone are computed.
    between: Y::PerStep<bool>,
    /// Steps downstream of the load, of which nothing upstream needs to be known.
    below: Y::PerStep<bool>,
}

impl<Y: Planned + ?Sized> Clone for FrequencyResponse<'_, Y> {
    fn clone(&self) -> Self {
        FrequencyResponse { ..*self }
    }
}

impl<Y: Planned + ?Sized> Wanted for FrequencyResponse<'_, Y> {
    fn leads_over(&self, step: usize) -> bool {
        self.between.as_ref()[step]
    }

    fn state(&self, step: usize, beyond: bool) -> bool {
        // the load's own point alone has two sides
        step == self.entry.step && (step != self.load.step || beyond == self.entry.beyond)
    }

    fn pick<S: Scalar>(&self, covector: Covector<S>, subspace: &Subspace<S>) -> ScaledState<S> {
        let coordinate = self.entry.coordinate;
        let (value, exponent) = covector.pick_entry(subspace, coordinate);
        let zero = State::default();
        let state = match coordinate {
            Coordinate::Y => State { y: value, ..zero },
            Coordinate::Theta => State { theta: value, ..zero },
            Coordinate::M => State { m: value, ..zero },
            _ => State { q: value, ..zero },
        };
        ScaledState { state, exponent }
    }
}

/// An entry of the state behind a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) step: usize,
    /// On the side of the step downstream of it.
    pub(super) beyond: bool,
    pub(super) coordinate: Coordinate,
}

impl Place {
    /// Where a load acts, and what it makes jump: Q or M.
    pub(super) fn of_load<Y: Planned + ?Sized>(load: Load<Y::Model>) -> Result<Self, MotionError> {
        Place::new(Y::scheme(), load.point.step, false, load.coordinate)
    }

    /// Where an entry is.
    pub(super) fn of_entry<Y: Planned + ?Sized>(entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        Place::new(Y::scheme(), entry.point.step, entry.point.beyond, entry.coordinate)
    }

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
        let load = Place::of_load::<Y>(load)?;
        let entry = Place::of_entry::<Y>(entry)?;
        let (mut between, mut below) = (Y::per_step(false), Y::per_step(false));
        for end in [load.step, entry.step] {
            let mut step = end;
            while !matches!(scheme.steps[step], Step::Root(..)) {
                between.as_mut()[step] ^= true;
                below.as_mut()[step] |= end == load.step && step != end;
                step = scheme.downstream(step);
            }
        }
        between.as_mut()[entry.step] = true;
        below.as_mut()[scheme.len() - 1] = true;
        Ok(FrequencyResponse { system, load, entry, between, below })
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
        let frequency = x.modulus();
        let Place { step, coordinate, .. } = self.load;
        let mut passes = Passes::from_tips(self.system, x, |step| !self.below.as_ref()[step]);
        passes.down_to(step);
        let delta = passes.delta(step);
        if delta.mantissa().is_zero() {
            return Err(MotionError::Resonance { frequency });
        }
        // a force acts towards Y, a moment towards Θ: Q grows by the one and M falls by the other
        let unit = if coordinate == Coordinate::M { -S::one() } else { S::one() };
        let factor = Scaled::new(unit, 0).over(delta);
        let jump = passes.jump(step, coordinate);
        let spread = passes.spread(step, jump.upstream, jump.downstream, self);
        let at_load = self.entry.beyond && self.entry.step == step;
        let state = if at_load { spread.beyond } else { spread.states.as_ref()[self.entry.step] };
        let entry = Scaled::new(state.state.entry(self.entry.coordinate), i64::from(state.exponent));
        let value = entry.product(factor).value();
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

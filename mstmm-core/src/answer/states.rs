//! The states of a whole system in one motion.

use crate::element::{CoefficientsOf, Inside, Moving, Visit};
use crate::model::{Ends, Label, MotionError, Point, State};
use crate::number::Single;
use crate::pass::state_recovery::RecoveredStates;
use crate::pass::tree::Tree;
use mstmm_plan::Step;

/// The states of a whole system in one motion.
#[derive(Debug)]
pub struct SystemStates<'a, Y: Tree<S> + ?Sized, S: Single> {
    pub(crate) system: &'a Y,
    pub(crate) x: S,
    /// The state behind each step; at the source on its upstream side.
    pub(crate) states: Y::PerStep<State<S>>,
    pub(crate) source: usize,
    /// The state at the source on its downstream side.
    pub(crate) beyond: State<S>,
}

impl<Y: Tree<S> + ?Sized, S: Single> Clone for SystemStates<'_, Y, S> {
    fn clone(&self) -> Self {
        SystemStates { ..*self }
    }
}

impl<'a, Y, S> SystemStates<'a, Y, S>
where
    Y: Tree<S> + ?Sized,
    S: Single,
{
    /// The states times `2^shift`.
    pub(crate) fn of(system: &'a Y, x: S, recovered: &RecoveredStates<Y, S>, shift: i32) -> Self {
        let mut states = Y::per_step(State::default());
        for (state, scaled) in states.as_mut().iter_mut().zip(recovered.states.as_ref()) {
            *state = scaled.shifted(shift);
        }
        SystemStates { system, x, states, source: recovered.source, beyond: recovered.beyond.shifted(shift) }
    }

    /// Applies a function to each state.
    pub(crate) fn map(&mut self, f: impl Fn(State<S>) -> State<S>) {
        for state in self.states.as_mut() {
            *state = f(*state);
        }
        self.beyond = f(self.beyond);
    }

    /// Adds the states of another motion times a factor; its source may be elsewhere.
    pub(crate) fn add(&mut self, other: &Self, factor: S) {
        let beyond = other.at(self.source, true);
        for (state, other) in self.states.as_mut().iter_mut().zip(other.states.as_ref()) {
            *state = state.plus(*other, factor);
        }
        self.beyond = self.beyond.plus(beyond, factor);
    }

    /// The states at both ends of the element of a step.
    pub(crate) fn ends(&self, step: usize) -> Ends<S> {
        let input = match self.system.scheme().steps.get(step) {
            Some(&Step::Element(input, _)) => self.at(input, true),
            _ => State::default(),
        };
        Ends { x: self.x, input, output: self.at(step, false) }
    }

    /// The interior of the element of a step, if it has one.
    pub(crate) fn inside(&self, step: usize) -> Option<Inside> {
        self.system.visit(None, step, InsideOf(self.x)).flatten()
    }

    /// The state inside of the element of a step.
    pub(crate) fn state_at(&self, step: usize, distance: f64) -> State<S> {
        self.system.visit(None, step, StateAt { ends: self.ends(step), distance }).unwrap_or_default()
    }

    /// The state at the point behind a step, on its upstream side or `beyond` it.
    pub(crate) fn at(&self, step: usize, beyond: bool) -> State<S> {
        if beyond && step == self.source {
            return self.beyond;
        }
        self.states.as_ref().get(step).copied().unwrap_or_default()
    }

    /// The state at an end of an element, or at the output of a connection. Entries that a path does not carry are zero.
    pub fn state(&self, point: Point<Y::Model>) -> State<S> {
        self.at(point.step, point.beyond)
    }

    /// The state inside of an element, at a distance \[m\] from its input end.
    ///
    /// # Errors
    /// [`MotionError::Outside`] for a distance beyond its ends; [`MotionError::NoInside`] for springs, masses and bodies.
    pub fn along<E>(&self, label: Label<Y::Model, E>, distance: f64) -> Result<State<S>, MotionError> {
        let Inside { length, .. } = self.inside(label.step).ok_or(MotionError::NoInside)?;
        if !(0.0..=length).contains(&distance) {
            return Err(MotionError::Outside { distance, length });
        }
        Ok(self.state_at(label.step, distance))
    }
}

struct InsideOf<S>(S);

impl<S: Single> Visit<S> for InsideOf<S> {
    type Output = Option<Inside>;

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> Option<Inside> {
        E::inside(built, self.0)
    }
}

struct StateAt<S> {
    ends: Ends<S>,
    distance: f64,
}

impl<S: Single> Visit<S> for StateAt<S> {
    type Output = State<S>;

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> State<S> {
        E::state_at(built, &self.ends, self.distance)
    }
}

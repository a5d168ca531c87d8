//! The route of a motion from a load to an entry of a state, and what arrives there.

use crate::model::{Entry, MotionError};
use crate::number::{Oscillation, Scaled, Single};
use crate::pass::both_ways::Passes;
use crate::pass::characteristic::System;
use crate::pass::jump::{Jump, Meeting};
use crate::pass::transfer_path::{Carried, Crossing, Follow};
use crate::pass::tree::{Planned, Tree};
use crate::subspace::{Covector, Subspace};
use mstmm_plan::{Coordinate, Scheme, Space, Step};

/// The side of the load on which the entry lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    /// Upstream of the load, or at its point on the upstream side.
    Upstream,
    /// Between the load and the root, or at the load's point on the downstream side.
    Downstream,
    /// On another path into a connection between the load and the root.
    Aside,
}

/// An entry of the state behind a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) step: usize,
    /// Whether the downstream side of the point is meant.
    pub(crate) beyond: bool,
    pub(crate) coordinate: Coordinate,
}

impl Place {
    /// The point of a load, with the entry that jumps there.
    pub(crate) fn of_load<Y: Planned + ?Sized>(
        system: &Y,
        (step, coordinate): (usize, Coordinate),
    ) -> Result<Self, MotionError> {
        Place::new(system.scheme(), step, false, coordinate)
    }

    /// The point of an entry.
    pub(crate) fn of_entry<Y: Planned + ?Sized>(system: &Y, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        Place::new(system.scheme(), entry.point.step, entry.point.beyond, entry.coordinate)
    }

    /// The entry at a point. At a connection whose output has fewer states it may be an entry of an input.
    fn new(scheme: Scheme<'_>, step: usize, beyond: bool, coordinate: Coordinate) -> Result<Self, MotionError> {
        let has = |step: usize| {
            let space = scheme.behind(step);
            space.contains(coordinate.freedom()) && !space.is(Space::Planar)
        };
        // the label of another list
        if step >= scheme.len() || matches!(scheme.steps[step], Step::Root(..)) {
            return Err(MotionError::NoSuchEntry { coordinate });
        }
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

/// The way from a load to an entry.
#[derive(Debug)]
pub(crate) struct Route<'a, Y: Planned + ?Sized> {
    pub(crate) system: &'a Y,
    pub(crate) load: Place,
    pub(crate) entry: Place,
    course: Course,
    /// Steps between load and entry, along which the motion is followed.
    between: Y::PerStep<bool>,
    /// Steps downstream of the load, whose upstream subspaces are not needed.
    below: Y::PerStep<bool>,
}

impl<Y: Planned + ?Sized> Clone for Route<'_, Y> {
    fn clone(&self) -> Self {
        Route { ..*self }
    }
}

impl<'a, Y: Planned + ?Sized> Route<'a, Y> {
    /// The route from a load to an entry.
    pub(crate) fn new(system: &'a Y, load: Place, entry: Place) -> Self {
        let scheme = system.scheme();
        let (mut between, mut below) = (Y::per_step(false), Y::per_step(false));
        let mut course = Course::Aside;
        for end in [load.step, entry.step] {
            let mut step = end;
            while !matches!(scheme.steps[step], Step::Root(..)) {
                if step == load.step && step == entry.step {
                    course = if entry.beyond { Course::Downstream } else { Course::Upstream };
                } else if end == load.step && step == entry.step {
                    course = Course::Downstream;
                } else if end == entry.step && step == load.step {
                    course = Course::Upstream;
                }
                between.as_mut()[step] ^= true;
                below.as_mut()[step] |= end == load.step && step != end;
                step = scheme.downstream(step);
            }
        }
        between.as_mut()[entry.step] = true;
        below.as_mut()[scheme.len() - 1] = true;
        Route { system, load, entry, course, between, below }
    }

    /// The subspaces along the transfer path.
    #[inline(always)]
    pub(crate) fn passes<S>(&self, x: S) -> Passes<'a, Y, S>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let mut passes = Passes::from_tips(self.system, x, |step| !self.below.as_ref()[step]);
        passes.down_to(self.load.step);
        passes
    }

    /// The response, given the subspaces along the transfer path.
    pub(crate) fn value<S>(&self, passes: &Passes<'_, Y, S>, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let (covector, delta) = self.start(&passes.meeting(self.load.step));
        let mut motion = Carried { passes, covector };
        self.follow(&mut motion);
        let subspaces = if self.course == Course::Downstream { &passes.downstream } else { &passes.upstream };
        self.entry_of(motion.covector, &subspaces.as_ref()[self.entry.step], delta, x)
    }

    /// The covector with which the motion leaves the load, times Δ, and Δ.
    fn start<S: Single>(&self, meeting: &Meeting<S>) -> (Covector<S>, Scaled<S>) {
        let Jump { upstream, downstream } = meeting.jump(self.load.coordinate);
        (if self.course == Course::Upstream { upstream } else { downstream }, meeting.delta())
    }

    /// Follows the motion from the load to the entry.
    fn follow(&self, motion: &mut impl Follow) {
        let scheme = self.system.scheme();
        let leads_over = |step: &usize| self.between.as_ref()[*step];
        let mut step = self.load.step;
        let mut is_downstream = self.course != Course::Upstream;
        while step != self.entry.step {
            let below = scheme.downstream(step);
            let next = if is_downstream { below } else { step };
            step = match scheme.steps[next] {
                Step::Connection(inputs) if !(is_downstream && leads_over(&below)) => {
                    let from = is_downstream.then_some(step);
                    let Some(&to) = inputs.iter().find(|input| Some(**input) != from && leads_over(input)) else {
                        return;
                    };
                    motion.through_connection(Crossing { at: next, from, to: Some(to) });
                    is_downstream = false;
                    to
                }
                Step::Connection(_) => {
                    motion.through_connection(Crossing { at: next, from: Some(step), to: None });
                    next
                }
                Step::Element(input, _) => {
                    motion.through(next, is_downstream);
                    if is_downstream { next } else { input }
                }
                Step::Tip(_) | Step::Root(..) => return,
            };
        }
    }

    /// The response, given the covector at the entry, the subspace that it belongs to and Δ.
    fn entry_of<S>(
        &self,
        covector: Covector<S>,
        subspace: &Subspace<S>,
        delta: Scaled<S>,
        x: S,
    ) -> Result<S, MotionError>
    where
        Y: System,
        S: Oscillation<Y::Parameter>,
    {
        if delta.mantissa().is_zero() {
            return Err(MotionError::Resonance { frequency: x.modulus() });
        }
        let coordinate = self.entry.coordinate;
        let (entry, exponent) = covector.pick_entry(subspace, coordinate);
        // seen from downstream slope and shear force have the other sign
        let is_reversed = self.course == Course::Downstream && matches!(coordinate, Coordinate::Theta | Coordinate::Q);
        // a force acts towards Y, a moment towards Θ: Q grows by the one and M falls by the other; a jump of -Y works with Q, one of Θ with M
        let falls = matches!(self.load.coordinate, Coordinate::M | Coordinate::Y);
        let unit = if is_reversed == falls { S::one() } else { -S::one() };
        let value = Scaled::new(entry, i64::from(exponent)).product(Scaled::new(unit, 0).over(delta)).value();
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency: x.modulus() }) }
    }
}

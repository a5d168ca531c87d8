//! Responses to harmonic loads.

use crate::answer::at_rest::{AtRest, Part};
use crate::answer::error::MotionError;
use crate::model::label::{Entry, Load};
use crate::model::state::{Coordinate, Space};
use crate::number::columns::InColumns;
use crate::number::frequency::Oscillation;
use crate::number::scalar::Scalar;
use crate::number::scaled::Scaled;
use crate::pass::block::both_ways::{BlockPasses, CarriedInBlock};
use crate::pass::block::{WIDTH, WORTHWHILE};
use crate::pass::both_ways::Passes;
use crate::pass::characteristic::System;
use crate::pass::jump::{Jump, Meeting, dual_of};
use crate::pass::transfer_path::{Carried, Crossing, Follow};
use crate::pass::tree::{Planned, Tree, TreeInBlocks};
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::{Scheme, Step};
use num_traits::One;

/// Systems of more steps are evaluated at one frequency after the other: the subspaces behind all steps are on the stack.
const LARGEST_IN_BLOCKS: usize = 64;

/// Roundings of Δ at low frequencies beside which it is nothing at rest.
const NOTHING: f64 = 4096.0;

/// A transfer function of a system: an entry of a state per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct FrequencyResponse<'a, Y: Planned + ?Sized> {
    system: &'a Y,
    load: Place,
    entry: Place,
    course: Course,
    /// Steps between the two, over which the motion is followed.
    between: Y::PerStep<bool>,
    /// Steps downstream of the load, of which nothing upstream needs to be known.
    below: Y::PerStep<bool>,
}

impl<Y: Planned + ?Sized> Clone for FrequencyResponse<'_, Y> {
    fn clone(&self) -> Self {
        FrequencyResponse { ..*self }
    }
}

/// Where the entry is, seen from the load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Course {
    /// Upstream of it, or at the same point on that side.
    Upstream,
    /// On the way to the root, or at the same point on that side.
    Downstream,
    /// On another path into a connection on the way to the root.
    Aside,
}

/// An entry of the state behind a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) step: usize,
    /// On the side of the step downstream of it.
    pub(crate) beyond: bool,
    pub(crate) coordinate: Coordinate,
}

impl Place {
    /// Where a load acts, and what it makes jump: Q or M.
    pub(crate) fn of_load<Y: Planned + ?Sized>(load: Load<Y::Model>) -> Result<Self, MotionError> {
        Place::new(Y::scheme(), load.point.step, false, load.coordinate)
    }

    /// Where an entry is.
    pub(crate) fn of_entry<Y: Planned + ?Sized>(entry: Entry<Y::Model>) -> Result<Self, MotionError> {
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
    pub(crate) fn new(system: &'a Y, load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let scheme = Y::scheme();
        let load = Place::of_load::<Y>(load)?;
        let entry = Place::of_entry::<Y>(entry)?;
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
        Ok(FrequencyResponse { system, load, entry, course, between, below })
    }

    /// The response at a frequency: a real ω [rad/s], or a complex λ [1/s], `iω` for a steady vibration.
    ///
    /// 0 is the static limit, wherever it is finite; it takes twice the time, to see that Δ is not a rounding there. Where nothing
    /// holds a part of the system, which the load does not move, it is extrapolated from some tens to hundreds of responses at
    /// low frequencies, to 12 digits of the largest of these. What the load moves off by no more than rounding is at rest.
    ///
    /// # Errors
    /// [`MotionError::Resonance`] where it is infinite, [`MotionError::Unsettled`] for a static limit that cannot be told,
    /// [`MotionError::NotFinite`] where the arithmetic overflows.
    pub fn at<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        if x.is_zero() { self.static_limit() } else { self.evaluated(x) }
    }

    /// The same where Δ does not vanish.
    fn evaluated<S>(&self, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        self.of(&self.passes(x), x)
    }

    /// The subspaces along the way.
    #[inline(always)]
    fn passes<S>(&self, x: S) -> Passes<'a, Y, S>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let mut passes = Passes::from_tips(self.system, x, |step| !self.below.as_ref()[step]);
        passes.down_to(self.load.step);
        passes
    }

    /// The response, given the subspaces along its way.
    fn of<S>(&self, passes: &Passes<'_, Y, S>, x: S) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let (covector, delta) = self.start(&passes.meeting(self.load.step));
        let mut motion = Carried { passes, covector };
        self.follow(&mut motion);
        let subspaces = if self.course == Course::Downstream { &passes.downstream } else { &passes.upstream };
        self.value(motion.covector, &subspaces.as_ref()[self.entry.step], delta, x)
    }

    /// The response and a size beside which rounding is small: the mean of what load and entry do to themselves, as the product of
    /// two entries of a mode is to their squares.
    pub(crate) fn sized<S>(&self, x: S) -> Result<Part<S>, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let passes = Passes::whole(self.system, x);
        let value = self.of(&passes, x)?;
        let own = |step: usize, coordinate: Coordinate| {
            let meeting = passes.meeting(step);
            meeting.square(coordinate).over(meeting.delta()).value().size()
        };
        let load = own(self.load.step, dual_of(self.load.coordinate));
        let entry = own(self.entry.step, self.entry.coordinate);
        Ok(Part { value, size: value.size().max(load.sqrt() * entry.sqrt()) })
    }

    /// The static limit.
    #[cold]
    fn static_limit<S>(&self) -> Result<S, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        if let Some(held) = self.held_at_rest()? {
            return Ok(held);
        }
        let rest = AtRest::of::<Y::Parameter>(self.system.estimates().lowest_exponent(), 0.0, |x| self.sized(x));
        let moves_off = Err(MotionError::Resonance { frequency: 0.0 });
        match rest {
            Ok(AtRest { double, simple, finite, .. }) if double.is_zero() && simple.is_zero() => Ok(finite),
            Ok(_) | Err(MotionError::Resonance { .. }) => moves_off,
            Err(error) => Err(error),
        }
    }

    /// The static limit of a system that is held; `None` where Δ vanishes at rest, or cannot be told from zero beside what it is
    /// at low frequencies.
    pub(crate) fn held_at_rest<S>(&self) -> Result<Option<S>, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let step = self.load.step;
        let low = <Y::Parameter as One>::one().times_power_of_two(self.system.estimates().lowest_exponent());
        let rest = self.passes(S::zero());
        let (own, beside) = (rest.meeting(step).delta(), self.passes(S::of_omega(low)).meeting(step).delta());
        if own.mantissa().is_zero() || own.over(beside).magnitude().value() <= NOTHING * S::EPSILON {
            return Ok(None);
        }
        self.of(&rest, S::zero()).map(Some)
    }

    /// The covector with which the motion leaves the load, times Δ, and Δ.
    fn start<S: Scalar>(&self, meeting: &Meeting<S>) -> (Covector<S>, Scaled<S>) {
        let Jump { upstream, downstream } = meeting.jump(self.load.coordinate);
        (if self.course == Course::Upstream { upstream } else { downstream }, meeting.delta())
    }

    /// Follows the motion from the load to the entry.
    fn follow(&self, motion: &mut impl Follow) {
        let scheme = Y::scheme();
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
    fn value<S>(&self, covector: Covector<S>, subspace: &Subspace<S>, delta: Scaled<S>, x: S) -> Result<S, MotionError>
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
        // a force acts towards Y, a moment towards Θ: Q grows by the one and M falls by the other
        let unit = if is_reversed == (self.load.coordinate == Coordinate::M) { S::one() } else { -S::one() };
        let value = Scaled::new(entry, i64::from(exponent)).product(Scaled::new(unit, 0).over(delta)).value();
        if value.size().is_finite() { Ok(value) } else { Err(MotionError::NotFinite { frequency: x.modulus() }) }
    }

    /// The response on a grid of the caller's, into memory of the caller's: each value has the bits that it has alone.
    ///
    /// Systems of up to 64 steps take the grid in blocks of frequencies, which costs a fraction of the time; memory for that is on
    /// the stack, some 3 kB per step for real frequencies, twice as much for complex ones: for ten steps a thread of 256 kB is
    /// enough, of 512 kB in debug builds.
    ///
    /// # Errors
    /// As [`at`](FrequencyResponse::at), for the first frequency where it fails; [`MotionError::Capacity`] where `values` is
    /// shorter than `grid`.
    pub fn on<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: TreeInBlocks<S>,
        S: Oscillation<Y::Parameter> + InColumns,
    {
        if values.len() < grid.len() {
            return Err(MotionError::Capacity { capacity: values.len() });
        }
        if grid.len() >= WORTHWHILE && Y::scheme().len() <= LARGEST_IN_BLOCKS {
            return self.in_blocks(grid, values);
        }
        self.one_by_one(grid, values)
    }

    fn one_by_one<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        for (value, &x) in values.iter_mut().zip(grid) {
            *value = self.at(x)?;
        }
        Ok(())
    }

    // a call: it takes much of the stack
    #[inline(never)]
    fn in_blocks<S>(&self, grid: &[S], values: &mut [S]) -> Result<(), MotionError>
    where
        Y: TreeInBlocks<S>,
        S: Oscillation<Y::Parameter> + InColumns,
    {
        let mut passes = BlockPasses::new(self.system);
        for (grid, values) in grid.chunks(WIDTH).zip(values.chunks_mut(WIDTH)) {
            let is_needed = |step: usize| !self.below.as_ref()[step];
            if grid.len() < WORTHWHILE || !passes.run::<Y::Parameter>(grid, is_needed, self.load.step) {
                self.one_by_one(grid, values)?;
                continue;
            }
            let starts: [_; WIDTH] = core::array::from_fn(|lane| self.start(&passes.meeting(self.load.step, lane)));
            let mut motion = CarriedInBlock { passes: &mut passes, covectors: starts.map(|(covector, _)| covector) };
            self.follow(&mut motion);
            let covectors = motion.covectors;
            for (lane, (value, &x)) in values.iter_mut().zip(grid).enumerate() {
                let subspace = passes.subspace(self.entry.step, self.course == Course::Downstream, lane);
                // where sums cancel nothing is made of them in a block
                let own = || self.value(covectors[lane], &subspace, starts[lane].1, x).or_else(|_| self.at(x));
                *value = if x.is_zero() { self.static_limit() } else { own() }?;
            }
        }
        Ok(())
    }
}

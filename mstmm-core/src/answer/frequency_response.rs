//! Responses to harmonic loads.

use crate::answer::at_rest::{AtRest, Part};
use crate::model::label::{Entry, Load};
use crate::model::motion_error::MotionError;
use crate::model::state::Coordinate;
use crate::number::columns::InColumns;
use crate::number::frequency::Oscillation;
use crate::number::scalar::Scalar;
use crate::pass::block::both_ways::BlockPasses;
use crate::pass::block::{WIDTH, WORTHWHILE};
use crate::pass::both_ways::Passes;
use crate::pass::jump::dual_of;
use crate::pass::route::{Place, Route};
use crate::pass::tree::{Planned, Tree};
use num_traits::One;

/// Systems of more steps are evaluated at one frequency after the other: the subspaces behind all steps are on the stack.
const LARGEST_IN_BLOCKS: usize = 64;

/// Roundings of Δ at low frequencies beside which it is nothing at rest.
const NOTHING: f64 = 4096.0;

/// A transfer function of a system: an entry of a state per harmonic load of 1 N, or of 1 N m.
#[derive(Debug)]
pub struct FrequencyResponse<'a, Y: Planned + ?Sized> {
    route: Route<'a, Y>,
}

impl<Y: Planned + ?Sized> Clone for FrequencyResponse<'_, Y> {
    fn clone(&self) -> Self {
        FrequencyResponse { route: self.route.clone() }
    }
}

impl<'a, Y: Planned + ?Sized> FrequencyResponse<'a, Y> {
    pub(crate) fn new(system: &'a Y, load: Load<Y::Model>, entry: Entry<Y::Model>) -> Result<Self, MotionError> {
        let (load, entry) = (Place::of_load(system, load)?, Place::of_entry(system, entry)?);
        Ok(FrequencyResponse { route: Route::new(system, load, entry) })
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
        self.route.value(&self.route.passes(x), x)
    }

    /// The response and a size beside which rounding is small: the mean of what load and entry do to themselves, as the product of
    /// two entries of a mode is to their squares.
    pub(crate) fn sized<S>(&self, x: S) -> Result<Part<S>, MotionError>
    where
        Y: Tree<S>,
        S: Oscillation<Y::Parameter>,
    {
        let passes = Passes::whole(self.route.system, x);
        let value = self.route.value(&passes, x)?;
        let own = |step: usize, coordinate: Coordinate| {
            let meeting = passes.meeting(step);
            meeting.square(coordinate).over(meeting.delta()).value().size()
        };
        let load = own(self.route.load.step, dual_of(self.route.load.coordinate));
        let entry = own(self.route.entry.step, self.route.entry.coordinate);
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
        let rest = AtRest::of::<Y::Parameter>(self.route.system.estimates().lowest_exponent(), 0.0, |x| self.sized(x));
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
        let step = self.route.load.step;
        let low = <Y::Parameter as One>::one().times_power_of_two(self.route.system.estimates().lowest_exponent());
        let rest = self.route.passes(S::zero());
        let (own, beside) = (rest.meeting(step).delta(), self.route.passes(S::of_omega(low)).meeting(step).delta());
        if own.mantissa().is_zero() || own.over(beside).magnitude().value() <= NOTHING * S::EPSILON {
            return Ok(None);
        }
        self.route.value(&rest, S::zero()).map(Some)
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
        Y: Tree<S>,
        S: Oscillation<Y::Parameter> + InColumns,
    {
        if values.len() < grid.len() {
            return Err(MotionError::Capacity { capacity: values.len() });
        }
        if grid.len() >= WORTHWHILE && self.route.system.scheme().len() <= LARGEST_IN_BLOCKS {
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
        Y: Tree<S>,
        S: Oscillation<Y::Parameter> + InColumns,
    {
        let mut passes = BlockPasses::new(self.route.system);
        for (grid, values) in grid.chunks(WIDTH).zip(values.chunks_mut(WIDTH)) {
            let is_known = grid.len() >= WORTHWHILE
                && self.route.in_block(&mut passes, grid, |lane, value| {
                    let x = grid[lane];
                    // where sums cancel nothing is made of them in a block
                    values[lane] = if x.is_zero() { self.static_limit() } else { value.or_else(|_| self.at(x)) }?;
                    Ok(())
                })?;
            if !is_known {
                self.one_by_one(grid, values)?;
            }
        }
        Ok(())
    }
}

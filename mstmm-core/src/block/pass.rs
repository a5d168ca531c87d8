//! The plane method over a block: a walker that keeps what is open in columns.

use super::acts::Through;
use super::connection::connection;
use super::lanes::{Frequencies, Lanes};
use super::loops::{Task, act, widest};
use super::root::{Values, at_root};
use super::tally::Tallies;
use super::walk::{Walk, Walker};
use super::{Straight, WIDTH};
use crate::at::At;
use crate::count::Tally;
use crate::element::PlaneStep;
use crate::scalar::{Frequency, InColumns};
use crate::state::{Space, Support};
use core::marker::PhantomData;

/// Paths that may be open at once: branches within branches.
const OPEN: usize = 12;

/// The pass at the frequencies of a block.
pub(super) struct BlockPass<S: InColumns, C> {
    at: Frequencies<S>,
    /// What is open in the first places, what is being made in the next.
    lanes: [Lanes<S>; OPEN + 2],
    /// Where each open path is; behind them the free places.
    places: [usize; OPEN + 2],
    open: usize,
    /// Whether too many paths were open, or lanes differ in kind.
    is_lost: bool,
    pub(super) tallies: Tallies<C>,
    pub(super) values: Values<S>,
}

/// The powers of frequencies, in straight-line code.
struct Powers<'a, S: InColumns, T> {
    of: &'a [S; WIDTH],
    to: &'a mut Frequencies<S>,
    parameter: PhantomData<T>,
}

impl<T, S: Frequency<T> + InColumns> Task for Powers<'_, S, T>
where
    Straight<S, false>: Frequency<T>,
{
    /// Whether all frequencies have a root in straight-line code.
    type Output = bool;

    #[inline(always)]
    fn run(self) -> bool {
        let mut are_good = true;
        for lane in 0..WIDTH {
            let at = At::new::<T>(Straight::<S, false>(self.of[lane]), true);
            are_good &= !at.powers[0].0.size().is_nan();
            self.to.set(lane, at, |number| number.0);
        }
        are_good
    }
}

impl<S: InColumns, C: Tally<S> + Copy + Default> BlockPass<S, C> {
    /// Room for passes, one after the other.
    pub(super) fn new() -> Self {
        BlockPass {
            at: Frequencies::new(),
            lanes: [Lanes::new(); OPEN + 2],
            places: core::array::from_fn(|place| place),
            open: 0,
            is_lost: false,
            tallies: Tallies::new(),
            values: Values::new(),
        }
    }

    /// Δ at the frequencies of a block, and what the tallies hear; the last frequency fills the lanes that remain. Returns whether
    /// there were any, and no more paths open at once than there is room for.
    pub(super) fn run<T, Y>(&mut self, system: &Y, frequencies: &[S]) -> bool
    where
        S: Frequency<T> + InColumns,
        Straight<S, false>: Frequency<T>,
        Y: Walk<S> + ?Sized,
    {
        let Some(&last) = frequencies.last() else { return false };
        let filled: [S; WIDTH];
        let all = match frequencies.first_chunk() {
            Some(all) => all,
            None => {
                filled = core::array::from_fn(|lane| frequencies.get(lane).copied().unwrap_or(last));
                &filled
            }
        };
        if !widest(Powers::<S, T> { of: all, to: &mut self.at, parameter: PhantomData }) {
            self.take_roots_alone::<T>(all);
        }
        (self.open, self.is_lost) = (0, false);
        self.tallies.heard_mut().fill(C::default());
        system.walk(self);
        !self.is_lost
    }

    /// Sets the frequencies of which straight-line code has no root.
    #[cold]
    fn take_roots_alone<T>(&mut self, all: &[S; WIDTH])
    where
        S: Frequency<T>,
    {
        for (lane, &x) in all.iter().enumerate() {
            if self.at.lane(lane, |number| number).powers[0].size().is_nan() {
                self.at.set(lane, At::new::<T>(x, true), |number| number);
            }
        }
    }
}

impl<S: InColumns, C: Tally<S> + Copy + Default> Walker<S> for BlockPass<S, C> {
    fn tip(&mut self, support: Support, space: Space) {
        self.is_lost |= self.open == OPEN;
        if !self.is_lost {
            self.lanes[self.places[self.open]].become_tip(support, space);
            self.open += 1;
        }
    }

    fn element<E>(&mut self, built: &E::Built)
    where
        E: PlaneStep<S> + PlaneStep<Straight<S, false>> + PlaneStep<Straight<S, true>>,
    {
        if !self.is_lost {
            let [top, free] = [self.places[self.open - 1], self.places[self.open]];
            let Ok([input, output]) = self.lanes.get_disjoint_mut([top, free]) else { return };
            act(&Through::<E, S> { built, at: &self.at }, input, output, &mut self.tallies);
            self.is_lost |= !output.is_uniform;
            self.places.swap(self.open - 1, self.open);
        }
    }

    fn connection(&mut self, inputs: &[usize], output: Option<Space>) {
        if self.is_lost {
            return;
        }
        let (base, top) = (self.open - inputs.len(), self.open);
        let paths = inputs.iter().map(|input| self.places[top - 1 - input]);
        self.is_lost |= paths.clone().any(|path| !self.lanes[path].is_uniform);
        let free = [self.places[top], self.places[top + 1]];
        let sum = connection(&mut self.lanes, paths, output, free, &mut self.tallies);
        // what is left of the inputs is free again
        if let Some(place) = self.places[base..].iter().position(|place| *place == sum) {
            self.places.swap(base, base + place);
        }
        self.open = base + 1;
    }

    fn root(&mut self, support: Support) {
        if self.is_lost {
            return;
        }
        let last = &self.lanes[self.places[self.open - 1]];
        at_root(last, support, &mut self.tallies, &mut self.values);
    }
}

//! The plane method over a block: a walker that keeps what is open in columns.

use crate::element::traits::PlaneStep;
use crate::model::state::{Space, Support};
use crate::number::branch_free::BranchFree;
use crate::number::columns::InColumns;
use crate::number::frequency::Frequency;
use crate::pass::block::connection::connection;
use crate::pass::block::counters::Counters;
use crate::pass::block::frequencies::Frequencies;
use crate::pass::block::lane_ops::Through;
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::act;
use crate::pass::block::root::{Values, at_root};
use crate::pass::block::walk::{Walk, Walker};
use crate::subspace::count::RootCounter;

/// Paths that may be open at once: branches within branches.
const OPEN: usize = 12;

/// The pass at the frequencies of a block.
pub(crate) struct BlockPass<S: InColumns, C> {
    at: Frequencies<S>,
    /// What is open in the first places, what is being made in the next.
    lanes: [Lanes<S>; OPEN + 2],
    /// Where each open path is; behind them the free places.
    places: [usize; OPEN + 2],
    open: usize,
    /// Whether too many paths were open, or lanes differ in kind.
    is_lost: bool,
    pub(crate) counters: Counters<C>,
    pub(crate) values: Values<S>,
}

impl<S: InColumns, C: RootCounter<S> + Copy + Default> BlockPass<S, C> {
    /// Room for passes, one after the other.
    pub(crate) fn new() -> Self {
        BlockPass {
            at: Frequencies::new(),
            lanes: [Lanes::new(); OPEN + 2],
            places: core::array::from_fn(|place| place),
            open: 0,
            is_lost: false,
            counters: Counters::new(),
            values: Values::new(),
        }
    }

    /// Δ at the frequencies of a block, and what the counters receive; the last frequency fills the lanes that remain. Returns whether
    /// there were any, and no more paths open at once than there is room for.
    pub(crate) fn run<T, Y>(&mut self, system: &Y, frequencies: &[S]) -> bool
    where
        S: Frequency<T> + InColumns,
        BranchFree<S, false>: Frequency<T>,
        Y: Walk<S> + ?Sized,
    {
        if !self.at.take::<T>(frequencies) {
            return false;
        }
        (self.open, self.is_lost) = (0, false);
        self.counters.committed_mut().fill(C::default());
        system.walk(self);
        !self.is_lost
    }
}

impl<S: InColumns, C: RootCounter<S> + Copy + Default> Walker<S> for BlockPass<S, C> {
    fn tip(&mut self, support: Support, space: Space) {
        self.is_lost |= self.open == OPEN;
        if !self.is_lost {
            self.lanes[self.places[self.open]].become_tip(support, space);
            self.open += 1;
        }
    }

    fn element<E>(&mut self, built: &E::Built)
    where
        E: PlaneStep<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>,
    {
        if !self.is_lost {
            let [top, free] = [self.places[self.open - 1], self.places[self.open]];
            let Ok([input, output]) = self.lanes.get_disjoint_mut([top, free]) else { return };
            act(&Through::<E, S> { built, at: &self.at }, input, output, &mut self.counters);
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
        let sum = connection(&mut self.lanes, paths, output, free, &mut self.counters);
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
        at_root(last, support, &mut self.counters, &mut self.values);
    }
}

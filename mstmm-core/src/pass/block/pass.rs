//! The plane method over a block: the subspaces of open paths stand in columns.

use crate::element::{Stepping, VisitStep};
use crate::number::{BranchFree, Frequency, InColumns};
use crate::pass::block::connection::connection;
use crate::pass::block::counters::Counters;
use crate::pass::block::frequencies::Frequencies;
use crate::pass::block::lane_ops::Through;
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::act;
use crate::pass::block::root::{Values, at_root};
use crate::pass::tree::Steps;
use crate::subspace::RootCounter;
use mstmm_plan::{Space, Step, Support};

/// Largest number of paths that are open at once: branches within branches.
const OPEN: usize = 12;

/// The pass at the frequencies of a block.
pub(crate) struct BlockPass<S: InColumns, C> {
    at: Frequencies<S>,
    /// The subspaces of open paths, in places, and two free places for results.
    lanes: [Lanes<S>; OPEN + 2],
    /// The place of each open path; behind them the free places.
    places: [usize; OPEN + 2],
    /// The last step of each open path.
    ends: [usize; OPEN],
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
            ends: [0; OPEN],
            open: 0,
            is_lost: false,
            counters: Counters::new(),
            values: Values::new(),
        }
    }

    /// Runs the pass with its counters; the last frequency fills the lanes that remain. Returns false without frequencies, with more
    /// open paths than there is room for, or where lanes differ in kind.
    pub(crate) fn run<T, Y>(&mut self, system: &Y, frequencies: &[S]) -> bool
    where
        S: Frequency<T> + InColumns,
        BranchFree<S, false>: Frequency<T>,
        Y: Steps<S> + ?Sized,
    {
        if !self.at.take::<T>(frequencies) {
            return false;
        }
        (self.open, self.is_lost) = (0, false);
        self.counters.committed_mut().fill(C::default());
        let scheme = system.scheme();
        for (index, step) in scheme.steps.iter().enumerate() {
            match *step {
                Step::Tip(support) => self.tip(support, scheme.space(index)),
                Step::Element(..) => {
                    system.visit_step(index, &mut *self);
                }
                Step::Connection(inputs) => self.connection(inputs, scheme.output(index)),
                Step::Root(_, support) => self.root(support),
            }
            if self.is_lost {
                return false;
            }
            // the last open path is behind this step
            self.ends[self.open - 1] = index;
        }
        true
    }

    fn tip(&mut self, support: Support, space: Space) {
        self.is_lost = self.open == OPEN;
        if !self.is_lost {
            self.lanes[self.places[self.open]].become_tip(support, space);
            self.open += 1;
        }
    }

    fn connection(&mut self, inputs: &[usize], output: Option<Space>) {
        let (base, top) = (self.open - inputs.len(), self.open);
        let (places, ends) = (&self.places, &self.ends);
        let place = |input: &usize| Some(places[base + ends[base..top].iter().position(|end| end == input)?]);
        let paths = inputs.iter().filter_map(place);
        self.is_lost = paths.clone().any(|path| !self.lanes[path].is_uniform);
        let free = [places[top], places[top + 1]];
        let sum = connection(&mut self.lanes, paths, output, free, &mut self.counters);
        // the other places of the inputs are free again
        if let Some(place) = self.places[base..].iter().position(|place| *place == sum) {
            self.places.swap(base, base + place);
        }
        self.open = base + 1;
    }

    fn root(&mut self, support: Support) {
        let last = &self.lanes[self.places[self.open - 1]];
        at_root(last, support, &mut self.counters, &mut self.values);
    }
}

impl<S: InColumns, C: RootCounter<S> + Copy + Default> VisitStep<S> for &mut BlockPass<S, C> {
    type Output = ();

    fn element<E: Stepping<S>>(self, built: &E::Built) {
        let [top, free] = [self.places[self.open - 1], self.places[self.open]];
        let Ok([input, output]) = self.lanes.get_disjoint_mut([top, free]) else { return };
        act(&Through::<E, S> { built, at: &self.at }, input, output, &mut self.counters);
        self.is_lost = !output.is_uniform;
        self.places.swap(self.open - 1, self.open);
    }
}

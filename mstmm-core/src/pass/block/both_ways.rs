//! The two subspaces behind every step of a tree at the frequencies of a block: that of the boundary conditions upstream, and that
//! of those downstream.

use crate::element::{CoefficientsOf, Moving, Visit};
use crate::number::{BranchFree, Frequency, InColumns};
use crate::pass::block::WIDTH;
use crate::pass::block::connection::connection;
use crate::pass::block::counters::Counters;
use crate::pass::block::frequencies::Frequencies;
use crate::pass::block::lane_ops::Through;
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::act;
use crate::pass::jump::Meeting;
use crate::pass::transfer_path::{Crossing, Follow};
use crate::pass::tree::Tree;
use crate::subspace::{Covector, NoCount, Subspace};
use mstmm_plan::{Space, Step};

/// A tree at the frequencies of a block, with the subspaces behind its steps.
pub(crate) struct BlockPasses<'a, Y: Tree<S> + ?Sized, S: InColumns> {
    system: &'a Y,
    at: Frequencies<S>,
    /// The upstream and the downstream subspace behind each step, the latter in the frame of a path that arrives from there. The
    /// places of the root are free.
    lanes: Y::PerStep<[Lanes<S>; 2]>,
    /// Whether lanes differ in kind.
    is_lost: bool,
}

/// Places of the two subspaces behind a step.
fn upstream(step: usize) -> usize {
    2 * step
}

fn downstream(step: usize) -> usize {
    2 * step + 1
}

impl<'a, Y: Tree<S> + ?Sized, S: InColumns> BlockPasses<'a, Y, S> {
    /// Passes in which nothing is evaluated yet.
    pub(crate) fn new(system: &'a Y) -> Self {
        BlockPasses { system, at: Frequencies::new(), lanes: Y::per_step([Lanes::new(); 2]), is_lost: false }
    }

    /// Both passes at some frequencies, at most as many as a block has: from the tips over the steps that are needed, and from the
    /// root down to a step. Returns whether the subspaces are known; the last frequency fills the lanes that remain.
    pub(crate) fn run<T>(&mut self, frequencies: &[S], needed: impl Fn(usize) -> bool, down_to: usize) -> bool
    where
        S: Frequency<T>,
        BranchFree<S, false>: Frequency<T>,
    {
        if !self.at.take::<T>(frequencies) {
            return false;
        }
        self.is_lost = false;
        let scheme = self.system.scheme();
        for step in (0..scheme.len() - 1).filter(|step| needed(*step)) {
            match scheme.steps[step] {
                Step::Tip(support) => self.places()[upstream(step)].become_tip(support, scheme.space(step)),
                Step::Element(input, _) => self.through(step, upstream(input), upstream(step), false),
                Step::Connection(inputs) => {
                    let inputs = inputs.iter().map(|input| upstream(*input));
                    self.connect(inputs, scheme.output(step), upstream(step));
                }
                Step::Root(..) => {}
            }
        }
        self.look_down_to(down_to);
        !self.is_lost
    }

    /// The subspaces that meet behind a step in a lane.
    pub(crate) fn meeting(&self, step: usize, lane: usize) -> Meeting<S> {
        Meeting {
            upstream: self.subspace(step, false, lane),
            downstream: self.subspace(step, true, lane).mirrored(),
            space: self.system.scheme().behind(step),
        }
    }

    /// The upstream or the downstream subspace behind a step in a lane.
    pub(crate) fn subspace(&self, step: usize, is_downstream: bool, lane: usize) -> Subspace<S> {
        self.lanes.as_ref()[step][usize::from(is_downstream)].lane(lane)
    }

    fn places(&mut self) -> &mut [Lanes<S>] {
        self.lanes.as_mut().as_flattened_mut()
    }

    /// The places of the root.
    fn free(&self) -> [usize; 2] {
        let root = self.system.scheme().len() - 1;
        [upstream(root), downstream(root)]
    }

    /// Sets the downstream subspaces of a step and of all steps between it and the root.
    fn look_down_to(&mut self, step: usize) {
        let scheme = self.system.scheme();
        let below = scheme.downstream(step);
        match scheme.steps[below] {
            Step::Root(_, support) => {
                let space = scheme.behind(step);
                self.places()[downstream(step)].become_tip(support, space);
            }
            Step::Connection(_) => {
                self.look_down_to(below);
                let crossing = Crossing { at: below, from: Some(step), to: None };
                let others = crossing.others(scheme).map(upstream).chain([downstream(below)]);
                self.places()[downstream(below)].mirror();
                self.connect(others, Some(scheme.behind(step)), downstream(step));
                self.places()[downstream(below)].mirror();
                self.places()[downstream(step)].mirror();
            }
            Step::Element(..) | Step::Tip(_) => {
                self.look_down_to(below);
                self.through(below, downstream(below), downstream(step), true);
            }
        }
    }

    /// Takes the subspaces of one place to another through the element of a step, or against its transfer direction.
    fn through(&mut self, step: usize, from: usize, to: usize, against: bool) {
        let lanes = self.lanes.as_mut().as_flattened_mut();
        if let Ok([input, output]) = lanes.get_disjoint_mut([from, to]) {
            self.system.visit(None, step, GoThrough { at: &self.at, input, output, against });
            self.is_lost |= !output.is_uniform;
        }
    }

    /// Joins the subspaces of some places into another place.
    fn connect(&mut self, inputs: impl Iterator<Item = usize> + Clone, output: Option<Space>, to: usize) {
        let free = self.free();
        let lanes = self.lanes.as_mut().as_flattened_mut();
        self.is_lost |= inputs.clone().any(|input| !lanes[input].is_uniform);
        let sum = connection(lanes, inputs, output, free, &mut Counters::<NoCount>::new());
        lanes[to] = lanes[sum];
    }
}

/// Takes subspaces through an element in the transfer direction, or against it.
struct GoThrough<'a, S: InColumns> {
    at: &'a Frequencies<S>,
    input: &'a Lanes<S>,
    output: &'a mut Lanes<S>,
    against: bool,
}

impl<S: InColumns> Visit<S> for GoThrough<'_, S> {
    type Output = ();

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) {
        let GoThrough { at, input, output, against } = self;
        let no_count = &mut Counters::<NoCount>::new();
        if against && !E::SYMMETRIC {
            let built = &E::reversed(built);
            act(&Through::<E, S> { built, at }, input, output, no_count);
        } else {
            act(&Through::<E, S> { built, at }, input, output, no_count);
        }
    }
}

/// The motions in all lanes.
pub(crate) struct CarriedInBlock<'a, 'y, Y: Tree<S> + ?Sized, S: InColumns> {
    pub(crate) passes: &'a mut BlockPasses<'y, Y, S>,
    pub(crate) covectors: [Covector<S>; WIDTH],
}

impl<Y: Tree<S> + ?Sized, S: InColumns> Follow for CarriedInBlock<'_, '_, Y, S> {
    fn through(&mut self, step: usize, against: bool) {
        let passes = &*self.passes;
        let inputs = match self.passes.system.scheme().steps[step] {
            Step::Element(input, _) if !against => &passes.lanes.as_ref()[input][0],
            _ => &passes.lanes.as_ref()[step][1],
        };
        let visitor = PullBack { at: &passes.at, inputs, covectors: &mut self.covectors, against };
        passes.system.visit(None, step, visitor);
    }

    fn through_connection(&mut self, crossing: Crossing) {
        let (scheme, at) = (self.passes.system.scheme(), crossing.at);
        let passes = &mut *self.passes;
        let beyond = downstream(at);
        let others = crossing.others(scheme).map(upstream);
        let others = others.chain(crossing.is_between_inputs().then_some(beyond));
        let [_, to] = passes.free();
        passes.places()[beyond].mirror();
        passes.connect(others, Some(scheme.space(at)), to);
        passes.places()[beyond].mirror();
        let space = passes.places()[beyond].kind.space();
        for (lane, covector) in self.covectors.iter_mut().enumerate() {
            *covector = crossing.carry(scheme, *covector, passes.places()[to].lane(lane), space);
        }
    }
}

/// Takes covectors to the input end of an element, or to its output end.
struct PullBack<'a, S: InColumns> {
    at: &'a Frequencies<S>,
    inputs: &'a Lanes<S>,
    covectors: &'a mut [Covector<S>; WIDTH],
    against: bool,
}

impl<S: InColumns> Visit<S> for PullBack<'_, S> {
    type Output = ();

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) {
        let reversed = (self.against && !E::SYMMETRIC).then(|| E::reversed(built));
        let built = reversed.as_ref().unwrap_or(built);
        for (lane, covector) in self.covectors.iter_mut().enumerate() {
            let links = E::back_coefficients(built, &self.at.lane(lane, |number| number));
            *covector = E::back_transfer(&links, &self.inputs.lane(lane), *covector).rescaled();
        }
    }
}

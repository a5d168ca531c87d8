//! Subspaces behind the steps of a tree at all frequencies of a block: what is upstream leaves of the state there, and what is
//! downstream.

use crate::element::energies::Energies;
use crate::element::traits::PlaneStep;
use crate::model::state::Space;
use crate::number::branch_free::BranchFree;
use crate::number::columns::InColumns;
use crate::number::frequency::Frequency;
use crate::pass::block::WIDTH;
use crate::pass::block::connection::connection;
use crate::pass::block::counters::Counters;
use crate::pass::block::frequencies::Frequencies;
use crate::pass::block::lane_ops::Through;
use crate::pass::block::lanes::Lanes;
use crate::pass::block::loops::act;
use crate::pass::jump::Meeting;
use crate::pass::transfer_path::{Crossing, Follow};
use crate::pass::tree::{TreeInBlocks, Visit, VisitInBlock};
use crate::subspace::count::NoCount;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::Step;

/// A tree at the frequencies of a block, with the subspaces behind its steps.
pub(crate) struct BlockPasses<'a, Y: TreeInBlocks<S> + ?Sized, S: InColumns> {
    system: &'a Y,
    at: Frequencies<S>,
    /// Behind each step, what is upstream leaves the first; what is downstream the second, in the frame of a path that arrives
    /// from there. Those of the root are free.
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

impl<'a, Y: TreeInBlocks<S> + ?Sized, S: InColumns> BlockPasses<'a, Y, S> {
    /// Room for them.
    pub(crate) fn new(system: &'a Y) -> Self {
        BlockPasses { system, at: Frequencies::new(), lanes: Y::per_step([Lanes::new(); 2]), is_lost: false }
    }

    /// Both passes at some frequencies, at most as many as a block has: from the tips over the steps that are needed, and from the
    /// root down to a step. Returns whether the subspaces are known; what remains of a block repeats the last frequency.
    pub(crate) fn run<T>(&mut self, frequencies: &[S], needed: impl Fn(usize) -> bool, down_to: usize) -> bool
    where
        S: Frequency<T>,
        BranchFree<S, false>: Frequency<T>,
    {
        if !self.at.take::<T>(frequencies) {
            return false;
        }
        self.is_lost = false;
        let scheme = Y::scheme();
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

    /// What meets behind a step in a lane.
    pub(crate) fn meeting(&self, step: usize, lane: usize) -> Meeting<S> {
        Meeting {
            upstream: self.subspace(step, false, lane),
            downstream: self.subspace(step, true, lane).mirrored(),
            space: Y::scheme().behind(step),
        }
    }

    /// What is upstream of a step leaves of the state behind it in a lane; or what is downstream.
    pub(crate) fn subspace(&self, step: usize, is_downstream: bool, lane: usize) -> Subspace<S> {
        self.lanes.as_ref()[step][usize::from(is_downstream)].lane(lane)
    }

    fn places(&mut self) -> &mut [Lanes<S>] {
        self.lanes.as_mut().as_flattened_mut()
    }

    /// The places of the root.
    fn free() -> [usize; 2] {
        let root = Y::scheme().len() - 1;
        [upstream(root), downstream(root)]
    }

    /// What is downstream of a step, and of all steps on its way to the root.
    fn look_down_to(&mut self, step: usize) {
        let scheme = Y::scheme();
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

    /// From one place to another through the element of a step, or against its transfer direction.
    fn through(&mut self, step: usize, from: usize, to: usize, against: bool) {
        let lanes = self.lanes.as_mut().as_flattened_mut();
        if let Ok([input, output]) = lanes.get_disjoint_mut([from, to]) {
            self.system.visit_in_block(step, GoThrough { at: &self.at, input, output, against });
            self.is_lost |= !output.is_uniform;
        }
    }

    /// The connection of what is in some places, to another place.
    fn connect(&mut self, inputs: impl Iterator<Item = usize> + Clone, output: Option<Space>, to: usize) {
        let lanes = self.lanes.as_mut().as_flattened_mut();
        self.is_lost |= inputs.clone().any(|input| !lanes[input].is_uniform);
        let sum = connection(lanes, inputs, output, Self::free(), &mut Counters::<NoCount>::new());
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

impl<S: InColumns> VisitInBlock<S> for GoThrough<'_, S> {
    fn element<E>(self, built: &E::Built)
    where
        E: Energies<S> + PlaneStep<BranchFree<S, false>> + PlaneStep<BranchFree<S, true>>,
    {
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

/// ModalAnalysis in all lanes.
pub(crate) struct CarriedInBlock<'a, 'y, Y: TreeInBlocks<S> + ?Sized, S: InColumns> {
    pub(crate) passes: &'a mut BlockPasses<'y, Y, S>,
    pub(crate) covectors: [Covector<S>; WIDTH],
}

impl<Y: TreeInBlocks<S> + ?Sized, S: InColumns> Follow for CarriedInBlock<'_, '_, Y, S> {
    fn through(&mut self, step: usize, against: bool) {
        let passes = &*self.passes;
        let inputs = match Y::scheme().steps[step] {
            Step::Element(input, _) if !against => &passes.lanes.as_ref()[input][0],
            _ => &passes.lanes.as_ref()[step][1],
        };
        let visitor = PullBack { at: &passes.at, inputs, covectors: &mut self.covectors, against };
        passes.system.visit(step, visitor);
    }

    fn through_connection(&mut self, crossing: Crossing) {
        let (scheme, at) = (Y::scheme(), crossing.at);
        let passes = &mut *self.passes;
        let beyond = downstream(at);
        let others = crossing.others(scheme).map(upstream);
        let others = others.chain(crossing.is_between_inputs().then_some(beyond));
        let [_, to] = BlockPasses::<Y, S>::free();
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

    fn element<E: Energies<S>>(self, built: &E::Built) {
        let reversed = (self.against && !E::SYMMETRIC).then(|| E::reversed(built));
        let built = reversed.as_ref().unwrap_or(built);
        for (lane, covector) in self.covectors.iter_mut().enumerate() {
            let links = E::links(built, &self.at.lane(lane, |number| number));
            *covector = E::back_transfer(&links, &self.inputs.lane(lane), *covector).rescaled();
        }
    }
}

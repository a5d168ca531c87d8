//! Recovery of the states of all steps from a source at one point, in the directions away from it.

use crate::model::ScaledState;
use crate::number::Scalar;
use crate::pass::both_ways::Passes;
use crate::pass::transfer_path::Crossing;
use crate::pass::tree::{Planned, Tree};
use crate::subspace::Covector;
use mstmm_plan::Step;

/// The states behind all steps; at the source on both sides.
#[derive(Debug)]
pub(crate) struct RecoveredStates<Y: Tree<S> + ?Sized, S: Scalar> {
    /// The state behind each step; at the source on the upstream side.
    pub(crate) states: Y::PerStep<ScaledState<S>>,
    pub(crate) source: usize,
    /// The state at the source on the downstream side.
    pub(crate) beyond: ScaledState<S>,
}

/// Covectors behind the steps that are still to be recovered.
type Pending<Y, S> = <Y as Planned>::PerStep<Option<Covector<S>>>;

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// Recovers the states from the covectors of the upstream and the downstream subspace at a source, the latter in the frame of a
    /// path that arrives from there.
    pub(crate) fn recover(
        &self,
        source: usize,
        upstream: Covector<S>,
        downstream: Covector<S>,
    ) -> RecoveredStates<Y, S> {
        let mut pending = Y::per_step(None);
        pending.as_mut()[source] = Some(upstream);
        let beyond = downstream.pick(&self.downstream.as_ref()[source]).backwards();
        let mut recovered = RecoveredStates { states: Y::per_step(ScaledState::zero()), source, beyond };
        let last = self.recover_downstream(source, downstream, &mut recovered, &mut pending);
        self.recover_upstream(&mut recovered, &mut pending);
        let states = recovered.states.as_mut();
        states[self.system.scheme().len() - 1] = if last == source { recovered.beyond } else { states[last] };
        recovered
    }

    /// Recovers the states from the source to the root; returns the last step before the root.
    fn recover_downstream(
        &self,
        source: usize,
        mut covector: Covector<S>,
        recovered: &mut RecoveredStates<Y, S>,
        pending: &mut Pending<Y, S>,
    ) -> usize {
        let scheme = self.system.scheme();
        let mut step = source;
        loop {
            let below = scheme.downstream(step);
            covector = match scheme.steps[below] {
                Step::Root(..) | Step::Tip(_) => return step,
                Step::Element(..) => self.pulled_back(below, covector, true),
                Step::Connection(inputs) => {
                    for &input in inputs.iter().filter(|input| **input != step) {
                        pending.as_mut()[input] =
                            Some(self.through_connection(
                                Crossing { at: below, from: Some(step), to: Some(input) },
                                covector,
                            ));
                    }
                    self.through_connection(Crossing { at: below, from: Some(step), to: None }, covector)
                }
            };
            recovered.states.as_mut()[below] = covector.pick(&self.downstream.as_ref()[below]).backwards();
            step = below;
        }
    }

    /// Recovers the states from all steps with a covector to the tips.
    fn recover_upstream(&self, recovered: &mut RecoveredStates<Y, S>, pending: &mut Pending<Y, S>) {
        let scheme = self.system.scheme();
        for step in (0..scheme.len()).rev() {
            let Some(covector) = pending.as_ref()[step] else { continue };
            recovered.states.as_mut()[step] = covector.pick(&self.upstream.as_ref()[step]);
            match scheme.steps[step] {
                Step::Tip(_) | Step::Root(..) => {}
                Step::Element(input, _) => {
                    pending.as_mut()[input] = Some(self.pulled_back(step, covector, false));
                }
                Step::Connection(inputs) => {
                    for &input in inputs {
                        pending.as_mut()[input] =
                            Some(self.through_connection(Crossing { at: step, from: None, to: Some(input) }, covector));
                    }
                }
            }
        }
    }
}

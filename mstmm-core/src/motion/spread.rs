//! States everywhere, from a source at one point: against all directions that lead to it.

use super::covector::{Covector, ScaledState};
use super::element::Motion;
use super::passes::Passes;
use super::tree::{Planned, Tree, Visit};
use crate::at::At;
use crate::layout::Step;
use crate::scalar::Scalar;
use crate::state::Space;
use crate::subspace::Subspace;

/// States behind steps, and at one of them, the source, on both sides.
#[derive(Debug)]
pub(crate) struct Spread<Y: Tree<S> + ?Sized, S: Scalar> {
    /// Behind each step; at the source on the upstream side.
    pub(crate) states: Y::PerStep<ScaledState<S>>,
    pub(crate) source: usize,
    /// At the source on the downstream side.
    pub(crate) beyond: ScaledState<S>,
}

/// Which steps are looked at.
pub(crate) trait Wanted {
    /// Whether the way of the source's motion to other steps leads over this one.
    fn leads_over(&self, step: usize) -> bool;
    /// Whether the state behind a step is asked for; at the source that on its upstream side, or beyond.
    fn state(&self, step: usize, beyond: bool) -> bool;
    /// What of such a state is asked for.
    fn pick<S: Scalar>(&self, covector: Covector<S>, subspace: &Subspace<S>) -> ScaledState<S> {
        covector.pick(subspace)
    }
}

/// All steps.
pub(crate) struct Everything;

impl Wanted for Everything {
    fn leads_over(&self, _step: usize) -> bool {
        true
    }

    fn state(&self, _step: usize, _beyond: bool) -> bool {
        true
    }
}

/// Takes a covector to the input end of an element, or to its output end.
struct PullBack<'a, S> {
    at: &'a At<S>,
    input: &'a Subspace<S>,
    covector: Covector<S>,
    against: bool,
}

impl<S: Scalar> Visit<S> for PullBack<'_, S> {
    type Output = Covector<S>;

    fn element<E: Motion<S>>(self, built: &E::Built) -> Covector<S> {
        let links = if self.against && !E::SYMMETRIC {
            E::links(&E::reversed(built), self.at)
        } else {
            E::links(built, self.at)
        };
        E::pull_back(&links, self.input, self.covector)
    }
}

/// Covectors behind the steps that are still to be spread.
type Pending<Y, S> = <Y as Planned>::PerStep<Option<Covector<S>>>;

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// Spreads the states from a source: a covector for what is upstream of it, and one for what is downstream, in the frame
    /// of a path that arrives from there. Steps that are not wanted keep a state of zeros.
    pub(crate) fn spread(
        &self,
        source: usize,
        upstream: Covector<S>,
        downstream: Covector<S>,
        wanted: &impl Wanted,
    ) -> Spread<Y, S> {
        let mut pending = Y::per_step(None);
        pending.as_mut()[source] = Some(upstream);
        let mut spread = Spread { states: Y::per_step(ScaledState::zero()), source, beyond: ScaledState::zero() };
        if wanted.state(source, true) {
            spread.beyond = wanted.pick(downstream, &self.downstream.as_ref()[source]).backwards();
        }
        let last = self.spread_downstream(source, downstream, &mut spread, &mut pending, wanted);
        self.spread_upstream(&mut spread, &mut pending, wanted);
        let states = spread.states.as_mut();
        states[Y::scheme().len() - 1] = if last == source { spread.beyond } else { states[last] };
        spread
    }

    /// From the source to the root; returns the last step before the root, or the last over which the way leads.
    fn spread_downstream(
        &self,
        source: usize,
        mut covector: Covector<S>,
        spread: &mut Spread<Y, S>,
        pending: &mut Pending<Y, S>,
        wanted: &impl Wanted,
    ) -> usize {
        let scheme = Y::scheme();
        let mut step = source;
        loop {
            let below = scheme.downstream(step);
            let beyond = &self.downstream.as_ref()[below];
            covector = match scheme.steps[below] {
                Step::Root(..) | Step::Tip(_) => return step,
                Step::Element(..) if !wanted.leads_over(below) => return step,
                Step::Element(..) => self.pulled_back(below, beyond, covector, true),
                Step::Connection(inputs) => {
                    let space = scheme.behind(step);
                    let sum = self.widened(below, covector.mirrored(space), space);
                    for &input in inputs.iter().filter(|input| **input != step && wanted.leads_over(**input)) {
                        pending.as_mut()[input] = Some(self.branch(below, inputs, input, Some(step), sum));
                    }
                    if !wanted.leads_over(below) {
                        return step;
                    }
                    self.trunk(below, inputs, step, sum)
                }
            };
            if wanted.state(below, false) {
                spread.states.as_mut()[below] = wanted.pick(covector, beyond).backwards();
            }
            step = below;
        }
    }

    /// From all steps with a covector to the tips.
    fn spread_upstream(&self, spread: &mut Spread<Y, S>, pending: &mut Pending<Y, S>, wanted: &impl Wanted) {
        let scheme = Y::scheme();
        for step in (0..scheme.len()).rev() {
            let Some(covector) = pending.as_ref()[step] else { continue };
            if wanted.state(step, false) {
                spread.states.as_mut()[step] = wanted.pick(covector, &self.upstream.as_ref()[step]);
            }
            match scheme.steps[step] {
                Step::Tip(_) | Step::Root(..) => {}
                Step::Element(input, _) => {
                    if wanted.leads_over(input) {
                        let subspace = &self.upstream.as_ref()[input];
                        pending.as_mut()[input] = Some(self.pulled_back(step, subspace, covector, false));
                    }
                }
                Step::Connection(inputs) => {
                    let sum = self.widened(step, covector, scheme.behind(step));
                    for &input in inputs.iter().filter(|input| wanted.leads_over(**input)) {
                        pending.as_mut()[input] = Some(self.branch(step, inputs, input, None, sum));
                    }
                }
            }
        }
    }

    /// A covector through the element of a step.
    fn pulled_back(&self, step: usize, input: &Subspace<S>, covector: Covector<S>, against: bool) -> Covector<S> {
        let visitor = PullBack { at: &self.at, input, covector, against };
        self.system.visit(step, visitor).unwrap_or(covector).moderated()
    }

    /// The covector of a path that leads to a connection in a narrower state, as that of the state of the connection: what
    /// does not go on has no force.
    fn widened(&self, connection: usize, covector: Covector<S>, space: Space) -> Covector<S> {
        let (zero, wide) = (S::zero(), Y::scheme().space(connection));
        match covector {
            Covector::Line(t, exponent) if wide.is(Space::Bending) => {
                let entries = if space.is(Space::Translation) { [zero, zero, t, zero] } else { [zero, zero, zero, t] };
                Covector::Plane(entries, exponent)
            }
            _ => covector,
        }
    }

    /// The covector of an input of a connection; `towards` is the input to which the sum leads, or downstream.
    fn branch(
        &self,
        connection: usize,
        inputs: &[usize],
        input: usize,
        towards: Option<usize>,
        sum: Covector<S>,
    ) -> Covector<S> {
        let scheme = Y::scheme();
        let beyond = towards.map(|_| self.downstream.as_ref()[connection].mirrored());
        let others = inputs.iter().filter(|other| Some(**other) != towards && **other != input);
        let paths = others.map(|&other| self.upstream.as_ref()[other]).chain(beyond);
        beside(paths, sum, self.space_at(input, connection), scheme.space(connection))
    }

    /// The covector of the path from downstream at a connection, where the sum leads to an input; in its own frame.
    fn trunk(&self, connection: usize, inputs: &[usize], towards: usize, sum: Covector<S>) -> Covector<S> {
        let scheme = Y::scheme();
        let others = inputs.iter().filter(|other| **other != towards);
        let paths = others.map(|&other| self.upstream.as_ref()[other]);
        let space = self.downstream.as_ref()[connection].space();
        beside(paths, sum, space, scheme.space(connection)).mirrored(space)
    }

    /// Space of the subspace that an input brings to a connection: a support has that of the connection.
    fn space_at(&self, input: usize, connection: usize) -> Space {
        match Y::scheme().steps[input] {
            Step::Tip(_) => Y::scheme().space(connection),
            _ => Y::scheme().behind(input),
        }
    }
}

/// The covector of a path of some space at a connection of a wider one, beside the sum of all other paths.
fn beside<S: Scalar>(
    others: impl Iterator<Item = Subspace<S>> + Clone,
    sum: Covector<S>,
    space: Space,
    wide: Space,
) -> Covector<S> {
    let others = crate::join::connection(others, Some(wide), &mut crate::count::Untallied);
    match sum {
        Covector::Line(t, exponent) => {
            let line = others.line();
            Covector::Line(line.y * t, exponent.saturating_add(line.exponent)).moderated()
        }
        Covector::Plane(..) if space.is(Space::Bending) => sum.beside(&others.plane()),
        Covector::Plane(..) => {
            let ScaledState { state, exponent } = sum.pick(&Subspace::Plane(others.plane()));
            let displacement = if space.is(Space::Translation) { state.y } else { state.theta };
            Covector::Line(displacement, exponent).moderated()
        }
    }
}

//! Subspaces behind every step of a tree: what the boundary conditions upstream leave of the state there, and what those
//! downstream leave of it.

use crate::element::energies::Energies;
use crate::model::state::{Space, Support};
use crate::number::frequency_powers::FrequencyPowers;
use crate::number::scalar::Scalar;
use crate::pass::tree::{Tree, VisitAt};
use crate::subspace::count::NoCount;
use crate::subspace::minors::join::connection;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::Step;

/// A tree at one frequency, with the subspaces behind its steps.
#[derive(Debug)]
pub(crate) struct Passes<'a, Y: Tree<S> + ?Sized, S: Scalar> {
    pub(crate) system: &'a Y,
    pub(crate) at: FrequencyPowers<S>,
    pub(crate) evaluated: Y::Evaluated,
    /// Behind each step, what is upstream leaves this.
    pub(crate) upstream: Y::PerStep<Subspace<S>>,
    /// Behind each step, what is downstream leaves this, in the frame of a path that arrives from there.
    pub(crate) downstream: Y::PerStep<Subspace<S>>,
}

/// Takes a subspace through an element in the transfer direction, or against it.
struct Through<'a, S> {
    at: &'a FrequencyPowers<S>,
    input: Subspace<S>,
    against: bool,
}

impl<S: Scalar> VisitAt<S> for Through<'_, S> {
    type Output = Subspace<S>;

    fn element<E: Energies<S>>(self, built: &E::Built, coefficients: &E::Coefficients) -> Subspace<S> {
        if self.against && !E::SYMMETRIC {
            let coefficients = E::coefficients(&E::reversed(built), self.at);
            return E::step(&coefficients, self.input, &mut NoCount);
        }
        E::step(coefficients, self.input, &mut NoCount)
    }
}

impl<'a, S: Scalar, Y: Tree<S> + ?Sized> Passes<'a, Y, S> {
    /// The pass from the tips to the root, without the steps of which `needed` says no; what is downstream is not known yet.
    pub(crate) fn from_tips(system: &'a Y, x: S, needed: impl Fn(usize) -> bool) -> Self {
        let at = Y::at(x);
        let nothing = Subspace::Tip(Support::Free, Space::Bending);
        let mut passes = Passes {
            system,
            evaluated: system.evaluate(&at),
            at,
            upstream: Y::per_step(nothing),
            downstream: Y::per_step(nothing),
        };
        let scheme = Y::scheme();
        for step in (0..scheme.len()).filter(|step| needed(*step)) {
            let subspace = match scheme.steps[step] {
                Step::Tip(support) => Subspace::Tip(support, scheme.space(step)),
                Step::Element(input, _) => passes.through(step, passes.upstream.as_ref()[input], false),
                Step::Connection(inputs) => passes.sum(inputs, None, None, scheme.output(step)),
                Step::Root(input, _) => passes.upstream.as_ref()[input],
            };
            passes.upstream.as_mut()[step] = subspace;
        }
        passes
    }

    /// Both passes, over all steps.
    pub(crate) fn whole(system: &'a Y, x: S) -> Self {
        let mut passes = Passes::from_tips(system, x, |_| true);
        passes.down_to_all();
        passes
    }

    /// The pass from the root to a step.
    pub(crate) fn down_to(&mut self, step: usize) {
        let scheme = Y::scheme();
        let below = scheme.downstream(step);
        if let Step::Connection(_) | Step::Element(..) = scheme.steps[below] {
            self.down_to(below);
        }
        self.look_down(step);
    }

    /// The pass from the root to all steps.
    fn down_to_all(&mut self) {
        for step in (0..Y::scheme().len() - 1).rev() {
            self.look_down(step);
        }
    }

    /// What is downstream of a step, given what is downstream of the next.
    fn look_down(&mut self, step: usize) {
        let scheme = Y::scheme();
        let below = scheme.downstream(step);
        let beyond = self.downstream.as_ref()[below];
        self.downstream.as_mut()[step] = match scheme.steps[below] {
            Step::Root(_, support) => Subspace::Tip(support, scheme.behind(step)),
            Step::Connection(inputs) => {
                self.sum(inputs, Some(step), Some(beyond.mirrored()), Some(scheme.behind(step))).mirrored()
            }
            Step::Element(..) | Step::Tip(_) => self.through(below, beyond, true),
        };
    }

    /// A subspace through the element of a step.
    fn through(&self, step: usize, input: Subspace<S>, against: bool) -> Subspace<S> {
        self.system.visit_at(&self.evaluated, step, Through { at: &self.at, input, against }).unwrap_or(input)
    }

    /// The sum of the paths at a connection, that from downstream among them if it is given, without one of the inputs, to go
    /// on in some space.
    pub(crate) fn sum(
        &self,
        inputs: &[usize],
        without: Option<usize>,
        from_downstream: Option<Subspace<S>>,
        output: Option<Space>,
    ) -> Subspace<S> {
        let others = inputs.iter().filter(|input| Some(**input) != without);
        let paths = others.map(|&input| self.upstream.as_ref()[input]).chain(from_downstream);
        connection(paths, output, &mut NoCount)
    }
}

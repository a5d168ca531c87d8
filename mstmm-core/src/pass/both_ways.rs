//! The two subspaces behind every step of a tree: that of the boundary conditions upstream, and that of those downstream.

use crate::element::{CoefficientsOf, Moving, Visit};
use crate::number::{FrequencyPowers, Scalar};
use crate::pass::tree::Tree;
use crate::subspace::{NoCount, Subspace, connection};
use mstmm_plan::{Space, Step, Support};

/// A tree at one frequency, with the subspaces behind its steps.
#[derive(Debug)]
pub(crate) struct Passes<'a, Y: Tree<S> + ?Sized, S: Scalar> {
    pub(crate) system: &'a Y,
    pub(crate) at: FrequencyPowers<S>,
    pub(crate) evaluated: Y::Evaluated,
    /// The subspace behind each step that the boundary conditions upstream leave.
    pub(crate) upstream: Y::PerStep<Subspace<S>>,
    /// The subspace behind each step that those downstream leave, in the frame of a path that arrives from there.
    pub(crate) downstream: Y::PerStep<Subspace<S>>,
}

/// Takes a subspace through an element in the transfer direction, or against it.
struct Through<'a, S> {
    at: &'a FrequencyPowers<S>,
    input: Subspace<S>,
    against: bool,
}

impl<S: Scalar> Visit<S> for Through<'_, S> {
    type Output = Subspace<S>;

    fn element<E: Moving<S>>(self, built: &E::Built, coefficients: Option<&CoefficientsOf<E, S>>) -> Subspace<S> {
        match coefficients {
            Some(coefficients) if E::SYMMETRIC || !self.against => E::step(coefficients, self.input, &mut NoCount),
            _ => {
                let reversed = if self.against { &E::reversed(built) } else { built };
                E::step(&E::coefficients(reversed, self.at), self.input, &mut NoCount)
            }
        }
    }
}

impl<'a, S: Scalar, Y: Tree<S> + ?Sized> Passes<'a, Y, S> {
    /// The pass from the tips to the root, without steps that are not `needed`. The downstream subspaces are not known yet.
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
        let scheme = system.scheme();
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

    /// Both passes over all steps.
    pub(crate) fn whole(system: &'a Y, x: S) -> Self {
        let mut passes = Passes::from_tips(system, x, |_| true);
        passes.down_to_all();
        passes
    }

    /// The pass from the root to a step.
    pub(crate) fn down_to(&mut self, step: usize) {
        let scheme = self.system.scheme();
        let below = scheme.downstream(step);
        if let Step::Connection(_) | Step::Element(..) = scheme.steps[below] {
            self.down_to(below);
        }
        self.look_down(step);
    }

    /// The pass from the root to all steps.
    fn down_to_all(&mut self) {
        for step in (0..self.system.scheme().len() - 1).rev() {
            self.look_down(step);
        }
    }

    /// Sets the downstream subspace of a step, from that of the next step.
    fn look_down(&mut self, step: usize) {
        let scheme = self.system.scheme();
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

    /// Takes a subspace through the element of a step.
    fn through(&self, step: usize, input: Subspace<S>, against: bool) -> Subspace<S> {
        self.system.visit(Some(&self.evaluated), step, Through { at: &self.at, input, against }).unwrap_or(input)
    }

    /// The sum of the paths at a connection without one of the inputs, with the path from downstream if it is given, in the space of
    /// the output.
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

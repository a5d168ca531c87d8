//! Transfer of covectors along a path of the tree: back through elements, and through connections from one path to another.

use crate::element::{CoefficientsOf, Moving, Visit};
use crate::model::ScaledState;
use crate::number::{FrequencyPowers, Scalar};
use crate::pass::both_ways::Passes;
use crate::pass::tree::Tree;
use crate::subspace::{Covector, NoCount, Subspace, connection};
use mstmm_plan::{Scheme, Space, Step};

/// Takes a covector to the input end of an element, or to its output end.
struct PullBack<'a, S> {
    at: &'a FrequencyPowers<S>,
    input: &'a Subspace<S>,
    covector: Covector<S>,
    against: bool,
}

impl<S: Scalar> Visit<S> for PullBack<'_, S> {
    type Output = Covector<S>;

    fn element<E: Moving<S>>(self, built: &E::Built, _: Option<&CoefficientsOf<E, S>>) -> Covector<S> {
        let coefficients = if self.against && !E::SYMMETRIC {
            E::back_coefficients(&E::reversed(built), self.at)
        } else {
            E::back_coefficients(built, self.at)
        };
        E::back_transfer(&coefficients, self.input, self.covector)
    }
}

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// Takes a covector through the element of a step, from its output to its input end or, `against`, the other way.
    pub(crate) fn pulled_back(&self, step: usize, covector: Covector<S>, against: bool) -> Covector<S> {
        let input = match self.system.scheme().steps[step] {
            Step::Element(input, _) if !against => &self.upstream.as_ref()[input],
            _ => &self.downstream.as_ref()[step],
        };
        let visitor = PullBack { at: &self.at, input, covector, against };
        self.system.visit(None, step, visitor).unwrap_or(covector).rescaled()
    }

    /// Takes a covector through a connection. The covector of the path downstream is in the frame of a path that arrives from there.
    pub(crate) fn through_connection(&self, crossing: Crossing, covector: Covector<S>) -> Covector<S> {
        let (scheme, at) = (self.system.scheme(), crossing.at);
        let others = crossing.others(scheme).map(|input| self.upstream.as_ref()[input]);
        let beyond = crossing.is_between_inputs().then(|| self.downstream.as_ref()[at].mirrored());
        let others = connection(others.chain(beyond), Some(scheme.space(at)), &mut NoCount);
        crossing.carry(scheme, covector, others, self.downstream.as_ref()[at].space())
    }
}

/// A motion, or many, that can be followed through a tree.
pub(crate) trait Follow {
    /// Follows the motion through the element of a step, from its output to its input end or, `against`, the other way.
    fn through(&mut self, step: usize, against: bool);

    /// Follows the motion through a connection.
    fn through_connection(&mut self, crossing: Crossing);
}

/// A motion at one frequency.
pub(crate) struct Carried<'a, 'y, Y: Tree<S> + ?Sized, S: Scalar> {
    pub(crate) passes: &'a Passes<'y, Y, S>,
    pub(crate) covector: Covector<S>,
}

impl<Y: Tree<S> + ?Sized, S: Scalar> Follow for Carried<'_, '_, Y, S> {
    fn through(&mut self, step: usize, against: bool) {
        self.covector = self.passes.pulled_back(step, self.covector, against);
    }

    fn through_connection(&mut self, crossing: Crossing) {
        self.covector = self.passes.through_connection(crossing, self.covector);
    }
}

/// The connection of a step with the path from which a motion comes and the path to which it goes; `None` is the path downstream.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) at: usize,
    pub(crate) from: Option<usize>,
    pub(crate) to: Option<usize>,
}

impl Crossing {
    /// The inputs that are neither `from` nor `to`.
    pub(crate) fn others<'a>(self, scheme: Scheme<'a>) -> impl Iterator<Item = usize> + Clone + use<'a> {
        let inputs = if let Step::Connection(inputs) = scheme.steps[self.at] { inputs } else { &[] };
        let Crossing { from, to, .. } = self;
        inputs.iter().copied().filter(move |input| Some(*input) != from && Some(*input) != to)
    }

    /// Whether both paths are inputs; then the path downstream is one of the others.
    pub(crate) fn is_between_inputs(self) -> bool {
        self.from.is_some() && self.to.is_some()
    }

    /// Carries a covector through the connection, given the sum of all other paths in the space of the connection, and the space of
    /// the subspace downstream.
    pub(crate) fn carry<S: Scalar>(
        self,
        scheme: Scheme<'_>,
        covector: Covector<S>,
        others: Subspace<S>,
        downstream: Space,
    ) -> Covector<S> {
        let space = scheme.behind(self.from.unwrap_or(self.at));
        let covector = if self.from.is_some() { covector.mirrored(space) } else { covector };
        let sum = widened(covector, space, scheme.space(self.at));
        match self.to {
            Some(input) => share_of(&others, sum, space_at(scheme, input, self.at)),
            None => share_of(&others, sum, downstream).mirrored(downstream),
        }
    }
}

/// The covector of a path with a narrower state, in the state of the connection: forces that the path does not carry are zero.
fn widened<S: Scalar>(covector: Covector<S>, space: Space, wide: Space) -> Covector<S> {
    let zero = S::zero();
    match covector {
        Covector::Line(t, exponent) if wide.is(Space::Bending) => {
            let entries = if space.is(Space::Translation) { [zero, zero, t, zero] } else { [zero, zero, zero, t] };
            Covector::Plane(entries, exponent)
        }
        _ => covector,
    }
}

/// Space of the subspace of an input at a connection; that of a support is the space of the connection.
fn space_at(scheme: Scheme<'_>, input: usize, connection: usize) -> Space {
    match scheme.steps[input] {
        Step::Tip(_) => scheme.space(connection),
        _ => scheme.behind(input),
    }
}

/// The covector of a path of some space at a connection of a wider one, given the sum of all other paths.
fn share_of<S: Scalar>(others: &Subspace<S>, sum: Covector<S>, space: Space) -> Covector<S> {
    match sum {
        Covector::Line(t, exponent) => {
            let line = others.line();
            Covector::Line(line.y * t, exponent.saturating_add(line.exponent)).rescaled()
        }
        Covector::Plane(..) if space.is(Space::Bending) => sum.share_of(&others.plane()),
        Covector::Plane(..) => {
            let ScaledState { state, exponent } = sum.pick(&Subspace::Plane(others.plane()));
            let displacement = if space.is(Space::Translation) { state.y } else { state.theta };
            Covector::Line(displacement, exponent).rescaled()
        }
    }
}

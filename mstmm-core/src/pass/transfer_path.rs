//! The way of a covector through a tree, step by step: against an element, and across a connection from one path to another.

use crate::element::energies::Energies;
use crate::model::scaled_state::ScaledState;
use crate::model::state::Space;
use crate::number::frequency_powers::FrequencyPowers;
use crate::number::scalar::Scalar;
use crate::pass::both_ways::Passes;
use crate::pass::tree::{Tree, Visit};
use crate::subspace::count::NoCount;
use crate::subspace::minors::covector::Covector;
use crate::subspace::minors::join::connection;
use crate::subspace::minors::subspace::Subspace;
use mstmm_plan::{Scheme, Step};

/// Takes a covector to the input end of an element, or to its output end.
struct PullBack<'a, S> {
    at: &'a FrequencyPowers<S>,
    input: &'a Subspace<S>,
    covector: Covector<S>,
    against: bool,
}

impl<S: Scalar> Visit<S> for PullBack<'_, S> {
    type Output = Covector<S>;

    fn element<E: Energies<S>>(self, built: &E::Built) -> Covector<S> {
        let links = if self.against && !E::SYMMETRIC {
            E::links(&E::reversed(built), self.at)
        } else {
            E::links(built, self.at)
        };
        E::back_transfer(&links, self.input, self.covector)
    }
}

impl<S: Scalar, Y: Tree<S> + ?Sized> Passes<'_, Y, S> {
    /// A covector from behind the element of a step to before it, or `against` the transfer direction the other way.
    pub(crate) fn pulled_back(&self, step: usize, covector: Covector<S>, against: bool) -> Covector<S> {
        let input = match Y::scheme().steps[step] {
            Step::Element(input, _) if !against => &self.upstream.as_ref()[input],
            _ => &self.downstream.as_ref()[step],
        };
        let visitor = PullBack { at: &self.at, input, covector, against };
        self.system.visit(step, visitor).unwrap_or(covector).rescaled()
    }

    /// A covector across a connection; that of the path downstream is always in the frame of a path that arrives from there.
    pub(crate) fn through_connection(&self, crossing: Crossing, covector: Covector<S>) -> Covector<S> {
        let (scheme, at) = (Y::scheme(), crossing.at);
        let others = crossing.others(scheme).map(|input| self.upstream.as_ref()[input]);
        let beyond = crossing.is_between_inputs().then(|| self.downstream.as_ref()[at].mirrored());
        let others = connection(others.chain(beyond), Some(scheme.space(at)), &mut NoCount);
        crossing.carry(scheme, covector, others, self.downstream.as_ref()[at].space())
    }
}

/// What follows a motion through a tree.
pub(crate) trait Follow {
    /// From behind the element of a step to before it, or `against` the transfer direction the other way.
    fn through(&mut self, step: usize, against: bool);

    /// Across a connection.
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

/// The way across the connection of a step, from one path to another; `None` is the path downstream.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Crossing {
    pub(crate) at: usize,
    pub(crate) from: Option<usize>,
    pub(crate) to: Option<usize>,
}

impl Crossing {
    /// The other inputs.
    pub(crate) fn others<'a>(self, scheme: Scheme<'a>) -> impl Iterator<Item = usize> + Clone + use<'a> {
        let inputs = if let Step::Connection(inputs) = scheme.steps[self.at] { inputs } else { &[] };
        let Crossing { from, to, .. } = self;
        inputs.iter().copied().filter(move |input| Some(*input) != from && Some(*input) != to)
    }

    /// Whether the way is from input to input: the path downstream is one of the others then.
    pub(crate) fn is_between_inputs(self) -> bool {
        self.from.is_some() && self.to.is_some()
    }

    /// Carries a covector across, given the sum of all other paths in the space of the connection, and the space of the subspace
    /// downstream.
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

/// The covector of a path that leads to a connection in a narrower state, as that of the state of the connection: what does not go
/// on has no force.
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

/// Space of the subspace that an input brings to a connection: a support has that of the connection.
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

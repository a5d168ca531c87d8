//! A visit of a model whose parts join something.

use crate::element::{Exact, MemberNumbers, OwnPart};
use crate::model::MemberPlane;
use crate::proof::frame::{IN_PLANE, Nodes, TWICE_IN_PLANE};
#[cfg(feature = "std")]
use crate::proof::frame::{IN_SPACE, TWICE_IN_SPACE};
#[cfg(not(feature = "std"))]
use crate::proof::join::Failure;
use crate::proof::join::Join;
use crate::proof::tree::{Path, Paths};
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use mstmm_plan::{Freedoms, Space, Support};

/// A run in progress.
struct Run<'m, J: Join, const M: usize, const TWO: usize> {
    model: &'m dyn Visited,
    /// The frequency, as the sum of two words, at which elements that are not known in numbers may be known; none where they are not.
    known_at: Option<[f64; 2]>,
    joining: J,
    paths: Paths<'m, J::Alone>,
    nodes: Nodes<M, TWO>,
}

/// Joins all parts of a model, in memory for its open paths.
#[inline(always)]
pub(crate) fn join_all<'m, J: Join>(
    model: &'m dyn Visited,
    known_at: Option<[f64; 2]>,
    joining: J,
    paths: &'m mut [Path<J::Alone>],
) -> J {
    let paths = Paths::new(paths);
    if model.is_flat() {
        let mut run = Run { model, known_at, joining, paths, nodes: Nodes::<IN_PLANE, TWICE_IN_PLANE>::new() };
        model.visit(&mut run);
        return run.joining;
    }
    join_in_space(model, known_at, joining, paths)
}

/// Joins all parts of a model in space.
#[cfg(feature = "std")]
fn join_in_space<'m, J: Join>(
    model: &'m dyn Visited,
    known_at: Option<[f64; 2]>,
    joining: J,
    paths: Paths<'m, J::Alone>,
) -> J {
    let mut run = Run { model, known_at, joining, paths, nodes: Nodes::<IN_SPACE, TWICE_IN_SPACE>::new() };
    model.visit(&mut run);
    run.joining
}

/// Without `std` there is no model in space.
#[cfg(not(feature = "std"))]
fn join_in_space<'m, J: Join>(_: &'m dyn Visited, _: Option<[f64; 2]>, mut joining: J, _: Paths<'m, J::Alone>) -> J {
    joining.fail(Failure::NotInNumbers);
    joining
}

impl<J: Join, const M: usize, const TWO: usize> Run<'_, J, M, TWO> {
    /// An element that is not known in numbers, which is known at one frequency.
    fn own_part(&self, place: usize, numbers: &MemberNumbers) -> Option<OwnPart> {
        match (numbers, self.known_at) {
            (MemberNumbers::Other, Some(omega)) => self.model.own_part(place, omega),
            _ => None,
        }
    }
}

impl<J: Join, const M: usize, const TWO: usize> Visitor for Run<'_, J, M, TWO> {
    fn tip(&mut self, step: usize, support: Support) {
        self.paths.tip(step, support, &mut self.joining);
    }

    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers) {
        self.joining.stands_at(step);
        if !self.joining.has_failed() {
            let own = self.own_part(step, numbers);
            self.paths.element([step, input], space, (numbers, own), &mut self.joining);
        }
    }

    fn connection(&mut self, step: usize, inputs: &[usize], output: Option<Space>) {
        self.joining.stands_at(step);
        if !self.joining.has_failed() {
            self.paths.connection(step, inputs, output, &mut self.joining);
        }
    }

    fn root(&mut self, input: usize, support: Support) {
        self.joining.stands_at(input);
        if !self.joining.has_failed() {
            self.paths.root(input, support, &mut self.joining);
        }
    }

    fn member(
        &mut self,
        (member, freedoms, plane): (usize, Freedoms, MemberPlane<Exact>),
        numbers: &MemberNumbers,
        ends: &[MemberEnd; 2],
        next: usize,
    ) {
        if !self.joining.has_failed() {
            let own = self.own_part(member, numbers);
            self.nodes.member((numbers, own), (freedoms, plane), ends, next, &mut self.joining);
        }
    }

    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: &[Exact; 6], centre: [Exact; 3]) {
        if !self.joining.has_failed() {
            self.nodes.body(node, (mass, inertia), centre, &mut self.joining);
        }
    }

    fn leave(&mut self, node: usize) {
        self.joining.stands_at(node);
        if !self.joining.has_failed() {
            self.nodes.leave(node, &mut self.joining);
        }
    }
}

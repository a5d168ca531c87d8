//! A visit of a model whose parts join something.

use crate::element::{Exact, MemberNumbers, OwnPart};
use crate::proof::frame::Nodes;
use crate::proof::join::Join;
use crate::proof::tree::{Path, Paths};
use crate::proof::visit::{MemberEnd, NodeNumbers, Visited, Visitor};
use mstmm_plan::{Freedoms, Space, Support};

/// A run in progress.
struct Run<'m, J: Join> {
    model: &'m dyn Visited,
    /// The frequency, as the sum of two words, at which elements that are not known in numbers may be known; none where they are not.
    known_at: Option<[f64; 2]>,
    joining: J,
    paths: Paths<'m, J::Alone>,
    nodes: Nodes,
}

/// Joins all parts of a model, in memory for its open paths.
#[inline(always)]
pub(crate) fn join_all<'m, J: Join>(
    model: &'m dyn Visited,
    known_at: Option<[f64; 2]>,
    joining: J,
    paths: &'m mut [Path<J::Alone>],
) -> J {
    let mut run = Run { model, known_at, joining, paths: Paths::new(paths), nodes: Nodes::new() };
    model.visit(&mut run);
    run.joining
}

impl<J: Join> Run<'_, J> {
    /// An element that is not known in numbers, which is known at one frequency.
    fn own_part(&self, place: usize, numbers: &MemberNumbers) -> Option<OwnPart> {
        match (numbers, self.known_at) {
            (MemberNumbers::Other, Some(omega)) => self.model.own_part(place, omega),
            _ => None,
        }
    }
}

impl<J: Join> Visitor for Run<'_, J> {
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

    fn member(&mut self, member: (usize, Freedoms), numbers: &MemberNumbers, ends: &[MemberEnd; 2], next: usize) {
        if !self.joining.has_failed() {
            let own = self.own_part(member.0, numbers);
            self.nodes.member((numbers, own, member.1), ends, next, &mut self.joining);
        }
    }

    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: Exact, centre: [Exact; 2]) {
        if !self.joining.has_failed() {
            self.nodes.body(node, [mass, inertia], centre, &mut self.joining);
        }
    }

    fn leave(&mut self, node: usize) {
        self.joining.stands_at(node);
        if !self.joining.has_failed() {
            self.nodes.leave(node, &mut self.joining);
        }
    }
}

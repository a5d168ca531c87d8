//! The visit: a model names its parts one after the other, and adds no other code to a proof.

use crate::element::{Exact, MemberNumbers};
use crate::model::Spot;
use mstmm_plan::{Freedoms, Scheme, Space, Step, Support};

/// What a model names its parts to: a tree its steps, a frame its members and nodes.
pub trait Visitor {
    /// A path starts from a support at a step.
    fn tip(&mut self, step: usize, support: Support);
    /// The path that has come to the step `input` goes through an element with these freedoms.
    fn element(&mut self, step: usize, input: usize, space: Space, numbers: &MemberNumbers);
    /// The paths that have come to some steps are joined, and go on with these freedoms, if another element follows.
    fn connection(&mut self, step: usize, inputs: &[usize], output: Option<Space>);
    /// The path that has come to the step `input` ends in the root.
    fn root(&mut self, input: usize, support: Support);

    /// A member between two nodes, of which one leaves next.
    fn member(&mut self, numbers: &MemberNumbers, ends: &[MemberEnd; 2], next: usize);
    /// A rigid body that moves with a node: its mass, its moment of inertia about its mass centre, and where that is.
    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: Exact, centre: [Exact; 2]);
    /// All parts that know a node have been named.
    fn leave(&mut self, node: usize);
}

/// A model that names its parts.
pub(crate) trait Visited {
    /// Names them.
    fn visit(&self, visitor: &mut dyn Visitor);
    /// What a node or a step is called.
    fn spot(&self, place: usize) -> Spot;
}

/// Whether all parts of a model are known in numbers.
pub(crate) fn is_in_numbers(model: &dyn Visited) -> bool {
    let mut known = Known(true);
    model.visit(&mut known);
    known.0
}

/// Looks whether all parts are known in numbers.
struct Known(bool);

impl Visitor for Known {
    fn tip(&mut self, _: usize, _: Support) {}

    fn element(&mut self, _: usize, _: usize, _: Space, numbers: &MemberNumbers) {
        self.0 &= !matches!(numbers, MemberNumbers::Other);
    }

    fn connection(&mut self, _: usize, _: &[usize], _: Option<Space>) {}

    fn root(&mut self, _: usize, _: Support) {}

    fn member(&mut self, numbers: &MemberNumbers, _: &[MemberEnd; 2], _: usize) {
        self.0 &= !matches!(numbers, MemberNumbers::Other);
    }

    fn body(&mut self, _: &NodeNumbers, _: Exact, _: Exact, _: [Exact; 2]) {}

    fn leave(&mut self, _: usize) {}
}

/// A node of a frame in numbers.
#[derive(Clone, Copy, Debug)]
pub struct NodeNumbers {
    /// Its index.
    pub index: usize,
    /// Its place.
    pub place: [Exact; 2],
    /// Its displacements along x and y and its rotation, as far as nothing holds them.
    pub free: Freedoms,
    /// The direction of its one displacement, of any length, if it has one; then x and y are not free.
    pub along: Option<[Exact; 2]>,
}

/// The end of a member in numbers.
#[derive(Clone, Copy, Debug)]
pub struct MemberEnd {
    /// Its node.
    pub node: NodeNumbers,
    /// Its place, tied rigidly to the node.
    pub place: [Exact; 2],
    /// The direction of its x axis, of any length; that from the first place to the second where there is none.
    pub along: Option<[Exact; 2]>,
    /// The freedoms that it does not share with the node, in the axes of the member.
    pub released: Freedoms,
}

/// Names the steps of a plan, given the numbers of the element of each.
pub fn visit_steps(scheme: Scheme<'_>, numbers: &dyn Fn(usize) -> MemberNumbers, visitor: &mut dyn Visitor) {
    for (index, step) in scheme.steps.iter().enumerate() {
        match *step {
            Step::Tip(support) => visitor.tip(index, support),
            Step::Element(input, space) => visitor.element(index, input, space, &numbers(index)),
            Step::Connection(inputs) => visitor.connection(index, inputs, scheme.output(index)),
            Step::Root(input, support) => visitor.root(input, support),
        }
    }
}

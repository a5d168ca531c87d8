//! The visit: a model names its parts one after the other, and adds no other code to a proof.

use crate::element::{Exact, MemberNumbers, OwnPart};
use crate::model::{MemberPlane, Skew, Spot};
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

    /// A member of an index, or a part of one, which acts in these freedoms in a plane, between two nodes, of which one leaves next.
    fn member(
        &mut self,
        member: (usize, Freedoms, MemberPlane<Exact>),
        numbers: &MemberNumbers,
        ends: &[MemberEnd; 2],
        next: usize,
    );
    /// A rigid body that moves with a node: its mass, its tensor of inertia about its mass centre, and where that is.
    fn body(&mut self, node: &NodeNumbers, mass: Exact, inertia: &[Exact; 6], centre: [Exact; 3]);
    /// All parts that know a node have been named.
    fn leave(&mut self, node: usize);
}

/// A model that names its parts.
pub(crate) trait Visited {
    /// Names them.
    fn visit(&self, visitor: &mut dyn Visitor);
    /// Whether all that it names moves in one plane.
    fn is_flat(&self) -> bool {
        true
    }
    /// What a node or a step is called.
    fn spot(&self, place: usize) -> Spot;
    /// The element of a step, or of a member, that is not known in numbers, at ω, which is the sum of two words.
    fn own_part(&self, step: usize, omega: [f64; 2]) -> Option<OwnPart>;
}

/// How much is known of the parts of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Knowledge {
    /// All are known in numbers: what is counted is proven.
    Numbers,
    /// Some are known by their stiffness at a frequency: they are counted without a proof.
    Stiffnesses,
    /// Some are not known.
    Nothing,
}

/// How much is known of the parts of a model.
pub(crate) fn knowledge_of(model: &dyn Visited) -> Knowledge {
    let mut known = Known { model, knowledge: Knowledge::Numbers };
    model.visit(&mut known);
    known.knowledge
}

/// Looks how much is known of all parts.
struct Known<'a> {
    model: &'a dyn Visited,
    knowledge: Knowledge,
}

impl Known<'_> {
    /// Looks how much is known of an element.
    fn look_at(&mut self, place: usize, numbers: &MemberNumbers) {
        if !numbers.parted().1.is_none() {
            // a count is that of an undamped system
            self.knowledge = Knowledge::Nothing;
        }
        if !matches!(numbers, MemberNumbers::Other) || self.knowledge == Knowledge::Nothing {
            return;
        }
        let is_known = self.model.own_part(place, [1.0, 0.0]).is_some();
        self.knowledge = if is_known { Knowledge::Stiffnesses } else { Knowledge::Nothing };
    }
}

impl Visitor for Known<'_> {
    fn tip(&mut self, _: usize, _: Support) {}

    fn element(&mut self, step: usize, _: usize, _: Space, numbers: &MemberNumbers) {
        self.look_at(step, numbers);
    }

    fn connection(&mut self, _: usize, _: &[usize], _: Option<Space>) {}

    fn root(&mut self, _: usize, _: Support) {}

    fn member(
        &mut self,
        member: (usize, Freedoms, MemberPlane<Exact>),
        numbers: &MemberNumbers,
        _: &[MemberEnd; 2],
        _: usize,
    ) {
        self.look_at(member.0, numbers);
    }

    fn body(&mut self, _: &NodeNumbers, _: Exact, _: &[Exact; 6], _: [Exact; 3]) {}

    fn leave(&mut self, _: usize) {}
}

/// A node of a frame in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeNumbers {
    /// Its index.
    pub index: usize,
    /// Its place.
    pub place: [Exact; 3],
    /// Its displacements and rotations, as far as nothing holds them.
    pub free: Freedoms,
    /// How it moves along directions, if it does; then no displacement is free.
    pub skew: Option<Skew<Exact>>,
}

/// The end of a member in numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberEnd {
    /// Its node.
    pub node: NodeNumbers,
    /// Its place, tied rigidly to the node.
    pub place: [Exact; 3],
    /// The direction of its x axis, of any length; that from the first place to the second where there is none.
    pub along: Option<[Exact; 3]>,
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

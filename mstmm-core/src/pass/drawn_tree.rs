//! What is drawn of a tree: its plan, with a name and an extent for each step.

use crate::element::ListElement;
use crate::model::{Extent, Label, Point, Spot, plain};
use crate::pass::planned_list::PlannedList;
use crate::pass::tree::Planned;
use mstmm_plan::{Space, Support};

/// A built system of which a [`TreeSketch`](crate::TreeSketch) tells what stands in which path.
pub trait DrawnTree: Planned {
    /// The name of the type of an element, and its extent; none where the step is none.
    fn drawn(&self, step: usize) -> Option<(&'static str, Extent)>;
}

/// A step of a model `M`: a support from which a path starts, an element, a connection of paths, or the root.
pub struct DrawnStep<'a, M> {
    /// What the source calls it.
    pub name: Spot,
    /// The steps from which it goes on, in the order of the source; none of a tip.
    pub inputs: &'a [usize],
    /// The space of its states, with which paths go on behind it.
    pub space: Space,
    /// What it is.
    pub part: DrawnPart,
    /// The element as motions are asked about it; none of a support and of a connection.
    pub label: Option<Label<M, ()>>,
    /// The point behind it.
    pub point: Point<M>,
}

/// What a step is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DrawnPart {
    /// A support: a tip, or the root, which is the last step.
    Support(Support),
    /// An element.
    Element {
        /// The name of its type, such as `FoundationBeam`; of an element of one's own that of its path.
        kind: &'static str,
        /// Where its ends are.
        extent: Extent,
    },
    /// A connection of paths.
    Connection,
}

plain!(DrawnStep<'a, M>, name, inputs, space, part, label, point);

impl<E: ListElement, const STEPS: usize> DrawnTree for PlannedList<'_, E, STEPS> {
    fn drawn(&self, step: usize) -> Option<(&'static str, Extent)> {
        self.element(step).map(|element| (element.name(), element.extent()))
    }
}

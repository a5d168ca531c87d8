//! What a built tree looks like.

use crate::model::{Label, Point};
use crate::pass::drawn_tree::{DrawnPart, DrawnStep, DrawnTree};
use mstmm_plan::Step;

/// A built tree with the names and the extents of its parts, on which drawings stand: the plan, in which paths join, without places.
///
/// It allocates nothing. Steps are in the order of an evaluation: each behind those from which it goes on, the root last.
#[derive(Debug)]
pub struct TreeSketch<'a, Y: ?Sized> {
    pub(crate) system: &'a Y,
}

impl<'a, Y: DrawnTree + ?Sized> TreeSketch<'a, Y> {
    /// The steps of the plan; indices of inputs lead into them.
    pub fn steps(&self) -> impl Iterator<Item = DrawnStep<'a, Y::Model>> + use<'a, Y> {
        let system = self.system;
        let scheme = system.scheme();
        scheme.steps.iter().enumerate().map(move |(index, step)| {
            let (part, label) = match *step {
                Step::Tip(support) | Step::Root(_, support) => (DrawnPart::Support(support), None),
                Step::Connection(_) => (DrawnPart::Connection, None),
                Step::Element(input, _) => {
                    let (kind, extent) = system.drawn(index).unwrap_or_default();
                    (DrawnPart::Element { kind, extent }, Some(Label::new(index, input)))
                }
            };
            DrawnStep {
                name: system.spot_of(index),
                inputs: step.inputs(),
                space: scheme.behind(index),
                part,
                label,
                point: Point::connection(index),
            }
        })
    }
}

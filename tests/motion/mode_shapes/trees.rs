//! Trees as data among the models whose shapes are checked; steps are named after their indices.

use crate::mode_shapes::recorded::{Ends, Recordable, Recorded, Sketched, plain};
use crate::mode_shapes::sketch::{Node, Sketch};
use crate::state_equations::steps_of;
use crate::support::list_of_tree::{MOST, Planned};
use crate::support::tree::{Part, Tree};
use mstmm::element::Support;
use mstmm::list::{InList, ListElement, ListStep};
use mstmm::motion::{ExtendedTree, ModeShape};
use mstmm::number::Oscillation;
use mstmm::search::System;
use mstmm_core::Step;

fn name(step: usize) -> String {
    format!("step_{step}")
}

fn support(support: Support) -> Node {
    Node::Support(format!("{support:?}").to_ascii_lowercase())
}

impl Sketched for Tree {
    fn sketch(&self) -> Sketch {
        let node = |(index, step): (usize, &ListStep<Part>)| match *step {
            ListStep::Tip(tip) => support(tip),
            ListStep::Connection(_) => Node::Connection(name(index)),
            ListStep::Root(root) => support(root),
            ListStep::Element(part) => Node::Element {
                kind: part.keyword().to_owned(),
                name: name(index),
                parameters: part.named().into_iter().map(|(name, value)| (name.to_owned(), value)).collect(),
            },
        };
        let arrows = |(index, step): (usize, &Step<'static>)| match *step {
            Step::Tip(_) => Vec::new(),
            Step::Element(input, _) | Step::Root(input, _) => vec![(input, index)],
            Step::Connection(inputs) => inputs.iter().map(|&input| (input, index)).collect(),
        };
        Sketch {
            nodes: self.iter().enumerate().map(node).collect(),
            arrows: steps_of(self).iter().enumerate().flat_map(arrows).collect(),
        }
    }
}

impl<E, S> Recordable<S> for Planned<E>
where
    E: ListElement,
    S: Oscillation<E::Parameter>,
    Self: ExtendedTree<S> + mstmm::motion::Planned<Model = InList> + System<Parameter = E::Parameter>,
{
    fn record<'a>(&self, shape: &'a ModeShape<'_, Self, S>, x: S) -> Recorded<'a> {
        let mut recorded = Recorded::at(x);
        for step in 0..MOST {
            if let Some(label) = self.label(step) {
                let ends = Ends {
                    input: plain(shape.state(label.input())),
                    output: plain(shape.state(label.output())),
                    along: Box::new(move |distance| plain(shape.along(label, distance).unwrap())),
                };
                recorded.elements.insert(name(step), ends);
            }
            if let Some(point) = self.connection(step) {
                recorded.connections.insert(name(step), plain(shape.state(point)));
            }
        }
        recorded
    }
}

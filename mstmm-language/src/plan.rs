//! The plan: a flat list of steps from the tips to the root. A step refers to earlier steps by index.

#[cfg(test)]
mod tests;
mod text;

use crate::ast::{Connection, Element, Kind, Parameter};
use crate::check::Tree;
use crate::diagnostics::Place;
use crate::keywords::support_of;
use crate::spans::meaning;
use crate::topology::Vertex;
use mstmm_plan::{Scheme, Space, Support, inputs_first};
use quote::ToTokens;
use std::collections::BTreeMap;
use syn::Ident;

/// One step; inputs are indices of earlier steps.
pub(crate) enum Step<'a> {
    /// A path starts from a support.
    Tip(&'a Ident),
    /// A path goes through an element, evaluated as the one at an index into [`Plan::elements`].
    Element { element: &'a Element, evaluated: usize, input: usize, arrow: Place },
    /// Paths are joined, in source order.
    Connection { connection: &'a Connection, inputs: Vec<usize> },
    /// All paths end in a support: the last step.
    Root { support: &'a Ident, input: usize },
}

impl Step<'_> {
    /// The tokens that a message about its states is at.
    pub(crate) fn place(&self) -> Place {
        match self {
            Step::Tip(support) | Step::Root { support, .. } => support.span().into(),
            Step::Element { arrow, .. } => *arrow,
            Step::Connection { connection, .. } => connection.place(),
        }
    }

    /// The step without its tokens; the space of an element of the user's own is known to rustc alone.
    fn without_tokens(&self) -> mstmm_plan::Step<'_> {
        match self {
            Step::Tip(keyword) => mstmm_plan::Step::Tip(support(keyword)),
            Step::Element { element, input, .. } => {
                mstmm_plan::Step::Element(*input, element.known().map_or(Space::NONE, |known| known.space))
            }
            Step::Connection { inputs, .. } => mstmm_plan::Step::Connection(inputs),
            Step::Root { support: keyword, input } => mstmm_plan::Step::Root(*input, support(keyword)),
        }
    }
}

/// What the emitted code evaluates, in order.
pub(crate) struct Plan<'a> {
    pub(crate) steps: Vec<Step<'a>>,
    /// Elements that differ: those of one kind with the same parameters, token by token, stand here once.
    pub(crate) elements: Vec<&'a Element>,
}

impl<'a> Plan<'a> {
    /// How many elements of the model are the one at an index into `elements`.
    pub(crate) fn uses_of(&self, index: usize) -> usize {
        let is_use = |step: &&Step<'_>| matches!(step, Step::Element { evaluated, .. } if *evaluated == index);
        self.steps.iter().filter(is_use).count()
    }

    /// Whether planar elements of the language stand in it, which take no part in searches.
    pub(crate) fn is_planar(&self) -> bool {
        self.elements.iter().any(|element| element.known().is_some_and(|known| known.space == Space::Planar))
    }

    /// The elements that spin: of a rotor.
    pub(crate) fn spinning(&self) -> impl Iterator<Item = &'a Element> {
        self.elements.iter().copied().filter(|element| element.spins())
    }

    /// Whether something spins: then it is a rotor.
    pub(crate) fn spins(&self) -> bool {
        self.spinning().next().is_some()
    }

    /// Whether elements of the user's own stand in it, whose states rustc alone knows.
    pub(crate) fn has_own_types(&self) -> bool {
        self.elements.iter().any(|element| element.known().is_none())
    }

    /// The steps at which states do not fit, each with what is wrong.
    pub(crate) fn misfits(&self) -> Vec<(&Step<'a>, &'static str)> {
        let steps = self.steps.iter().enumerate();
        self.resolved(|scheme| steps.filter_map(|(index, step)| Some((step, scheme.misfit(index)?))).collect())
    }

    /// Plans a checked tree: depth first from the root, inputs in source order, so that inputs precede outputs.
    pub(crate) fn of(tree: &Tree<'_, 'a>) -> Self {
        let mut plan = Plan { steps: Vec::new(), elements: Vec::new() };
        let mut known = BTreeMap::new();
        let mut step_of = BTreeMap::new();
        let edges: Vec<(usize, usize)> = tree.graph.edges.iter().map(|edge| (edge.from, edge.to)).collect();
        for &vertex in inputs_first(&edges, tree.root, &mut vec![0; tree.graph.vertices.len()]) {
            let inputs: Vec<usize> = tree.graph.inputs(vertex).iter().map(|input| step_of[input]).collect();
            let step = match &tree.graph.vertices[vertex] {
                Vertex::Support(support) if vertex == tree.root => Step::Root { support, input: inputs[0] },
                Vertex::Support(support) => Step::Tip(support),
                Vertex::Connection(connection) => Step::Connection { connection, inputs },
                Vertex::Element(element) => {
                    let next = plan.elements.len();
                    let evaluated = *known.entry(identity(element)).or_insert(next);
                    if evaluated == next {
                        plan.elements.push(element);
                    }
                    let edge = tree.graph.edges.iter().find(|edge| edge.to == vertex);
                    let arrow = edge.map_or_else(|| element.place(), |edge| edge.place);
                    Step::Element { element, evaluated, input: inputs[0], arrow }
                }
            };
            step_of.insert(vertex, plan.steps.len());
            plan.steps.push(step);
        }
        plan
    }

    /// The steps at which one of the [`elements`](Self::elements) stands.
    pub(crate) fn steps_of(&self, element: usize) -> Vec<usize> {
        let stands = |step: &Step<'_>| matches!(step, Step::Element { evaluated, .. } if *evaluated == element);
        (0..self.steps.len()).filter(|&index| stands(&self.steps[index])).collect()
    }

    /// Whether a step is a support that holds a connection.
    pub(crate) fn holds_connection(&self, step: usize) -> bool {
        self.steps.iter().any(|next| matches!(next, Step::Connection { inputs, .. } if inputs.contains(&step)))
    }

    /// Width of the overall matrix, if the macro knows the states of all elements.
    pub(crate) fn size(&self) -> Option<usize> {
        self.resolved(|scheme| is_known(scheme).then(|| scheme.size()))
    }

    /// Asks the plan what follows from it, as far as the macro knows the states of elements.
    fn resolved<R>(&self, ask: impl FnOnce(Scheme<'_>) -> R) -> R {
        let steps: Vec<_> = self.steps.iter().map(Step::without_tokens).collect();
        let (mut places, mut inputs) = (vec![mstmm_plan::Place::NOWHERE; steps.len()], vec![0; steps.len()]);
        ask(Scheme::resolve(&steps, &mut places, &mut inputs))
    }
}

/// Whether the macro knows the states of all steps.
fn is_known(scheme: Scheme<'_>) -> bool {
    scheme.places.iter().all(|place| !place.space.is_empty())
}

/// The support of a keyword. `check` has refused unknown ones.
pub(crate) fn support(keyword: &Ident) -> Support {
    support_of(&keyword.to_string()).unwrap_or(Support::Fixed)
}

/// Kind and parameters as text, in the order of the names: equal for elements that are the same.
fn identity(element: &Element) -> (String, BTreeMap<String, String>) {
    let kind = match &element.kind {
        Kind::Keyword(keyword) => keyword.to_string(),
        Kind::Type(path) => meaning(path.to_token_stream()),
    };
    let value = |parameter: &Parameter| match &parameter.value {
        Some(value) => meaning(value.to_token_stream()),
        None => meaning(parameter.name.to_token_stream()),
    };
    (kind, element.parameters().map(|p| (p.name.to_string(), value(p))).collect())
}

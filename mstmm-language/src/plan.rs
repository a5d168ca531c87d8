//! The plan: a flat list of steps from the tips to the root. A step refers to earlier steps by index.

mod sizes;
#[cfg(test)]
mod tests;
mod text;

use crate::ast::{Connection, Element, Kind, Parameter};
use crate::check::Tree;
use crate::diagnostics::Place;
use crate::spans::origin;
use crate::topology::Vertex;
use proc_macro2::{TokenStream, TokenTree};
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
    /// Earlier steps from which this one goes on.
    fn inputs(&self) -> &[usize] {
        match self {
            Step::Tip(_) => &[],
            Step::Element { input, .. } | Step::Root { input, .. } => std::slice::from_ref(input),
            Step::Connection { inputs, .. } => inputs,
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

    /// Plans a checked tree: depth first from the root, inputs in source order, so that inputs precede outputs.
    pub(crate) fn of(tree: &Tree<'_, 'a>) -> Self {
        let mut plan = Plan { steps: Vec::new(), elements: Vec::new() };
        let mut known = BTreeMap::new();
        let mut step_of = BTreeMap::new();
        for vertex in inputs_first(tree) {
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
        self.downstream(step).is_some_and(|next| matches!(self.steps[next], Step::Connection { .. }))
    }

    /// The step that takes another as input; none takes the root.
    fn downstream(&self, index: usize) -> Option<usize> {
        self.steps.iter().position(|step| step.inputs().contains(&index))
    }
}

/// The vertices of a tree, each behind all its inputs.
fn inputs_first(tree: &Tree<'_, '_>) -> Vec<usize> {
    let mut root_first = Vec::new();
    let mut pending = vec![tree.root];
    while let Some(vertex) = pending.pop() {
        root_first.push(vertex);
        pending.extend(tree.graph.inputs(vertex));
    }
    root_first.reverse();
    root_first
}

/// Kind and parameters as text, in the order of the names: equal for elements that are the same.
fn identity(element: &Element) -> (String, BTreeMap<String, String>) {
    let kind = match &element.kind {
        Kind::Keyword(keyword) => keyword.to_string(),
        Kind::Type(path) => text(path.to_token_stream()),
    };
    let value = |parameter: &Parameter| match &parameter.value {
        Some(value) => text(value.to_token_stream()),
        None => text(parameter.name.to_token_stream()),
    };
    (kind, element.parameters().map(|p| (p.name.to_string(), value(p))).collect())
}

/// Tokens as text in which equal names of different origin differ.
fn text(tokens: TokenStream) -> String {
    let mut text = String::new();
    for tree in tokens {
        match tree {
            TokenTree::Ident(name) => text += &format!("{name}{} ", origin(name.span())),
            TokenTree::Group(group) => text += &format!("{:?}{{ {}}} ", group.delimiter(), self::text(group.stream())),
            other => text += &format!("{other} "),
        }
    }
    text
}

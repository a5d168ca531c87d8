//! The rules of the language, each with a message at the user's token.

use crate::ast::{Kind, Model, Node};
use crate::diagnostics::Errors;
use crate::keywords::{CONNECTION, ELEMENTS, SUPPORTS, look_up, nearest};
use crate::topology::{Graph, Vertex};
use proc_macro2::Span;
use std::collections::BTreeSet;
use syn::{Fields, Ident, Type};

/// Rules that need no graph: fields, keywords, parameters given twice.
pub(crate) fn language(model: &Model) -> syn::Result<()> {
    let mut errors = Errors::default();
    check_struct(model, &mut errors);
    if model.paths.is_empty() {
        let message = "this model has no path: add one, such as `fixed -> beam 1 { .. } -> free;`";
        errors.push(model.parameters.ident.span(), message);
    }
    let nodes =
        model.paths.iter().flat_map(|path| std::iter::once(&path.first).chain(path.rest.iter().map(|(_, n)| n)));
    for node in nodes {
        match node {
            Node::Support(keyword) => check_support(keyword, &mut errors),
            Node::Connection(_) => {}
            Node::Element(element) => {
                if let Kind::Keyword(keyword) = &element.kind {
                    check_keyword(keyword, &mut errors);
                }
                let mut seen = BTreeSet::new();
                for parameter in &element.parameters {
                    if !seen.insert(parameter.name.to_string()) {
                        errors.push(parameter.name.span(), format!("`{element}` gives `{}` twice", parameter.name));
                    }
                }
            }
        }
    }
    errors.propagate()
}

/// The struct of parameters has named fields of type `f64` and no generics.
fn check_struct(model: &Model, errors: &mut Errors) {
    let item = &model.parameters;
    if !item.generics.params.is_empty() {
        errors.push(item.ident.span(), "the struct of a model takes no generic parameters");
    }
    match &item.fields {
        Fields::Named(fields) => {
            for field in &fields.named {
                if !matches!(&field.ty, Type::Path(path) if path.path.is_ident("f64")) {
                    let span = syn::spanned::Spanned::span(&field.ty);
                    errors.push(span, "a field of a model is an `f64`: compute anything else in a `let` line");
                }
            }
        }
        Fields::Unit => {}
        Fields::Unnamed(_) => {
            errors
                .push(item.ident.span(), "the struct of a model has named fields, `struct Model { length: f64, .. }`");
        }
    }
}

fn check_support(keyword: &Ident, errors: &mut Errors) {
    let text = keyword.to_string();
    if look_up(SUPPORTS, &text).is_some() {
        return;
    }
    if look_up(ELEMENTS, &text).is_some() {
        errors.push(keyword.span(), format!("`{text}` needs a label and parameters, `{text} 1 {{ .. }}`"));
        return;
    }
    let hint = match nearest(SUPPORTS.iter().map(|(name, _)| *name), &text) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the supports are {}", list(SUPPORTS)),
    };
    errors.push(keyword.span(), format!("`{text}` is not a support: {hint}"));
}

fn check_keyword(keyword: &Ident, errors: &mut Errors) {
    let text = keyword.to_string();
    if look_up(ELEMENTS, &text).is_some() {
        return;
    }
    if look_up(SUPPORTS, &text).is_some() {
        errors.push(keyword.span(), format!("the support `{text}` takes no label and no parameters"));
        return;
    }
    let known = ELEMENTS.iter().map(|(name, _)| *name).chain([CONNECTION]);
    let hint = match nearest(known, &text) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the elements are {}, or a type of your own by a path with `::`", list(ELEMENTS)),
    };
    errors.push(keyword.span(), format!("`{text}` is not an element: {hint}"));
}

/// The keywords of a table, for a message.
fn list(table: &[(&str, &str)]) -> String {
    table.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A graph that is a tree of transfer paths: every arrow leads to the root.
pub(crate) struct Tree<'g, 'a> {
    pub(crate) graph: &'g Graph<'a>,
    pub(crate) root: usize,
}

/// Rules of the graph.
pub(crate) fn topology<'g, 'a>(graph: &'g Graph<'a>) -> syn::Result<Tree<'g, 'a>> {
    let mut errors = Errors::default();
    for vertex in 0..graph.vertices.len() {
        check_ends(graph, vertex, &mut errors);
    }
    for edge in &graph.edges {
        if edge.from == edge.to {
            errors.push(edge.span, format!("`{}` is joined to itself", graph.vertices[edge.from].name()));
        }
    }
    let root = find_root(graph, &mut errors);
    errors.propagate()?;
    let Some(root) = root else { return Err(syn::Error::new(Span::call_site(), "this model has no root")) };
    check_reach(graph, root)?;
    Ok(Tree { graph, root })
}

/// Number of inputs and outputs of one vertex.
fn check_ends(graph: &Graph<'_>, index: usize, errors: &mut Errors) {
    let vertex = &graph.vertices[index];
    let inputs: Vec<Span> = graph.edges.iter().filter(|edge| edge.to == index).map(|edge| edge.span).collect();
    let outputs: Vec<Span> = graph.edges.iter().filter(|edge| edge.from == index).map(|edge| edge.span).collect();
    let name = vertex.name();
    let mut push = |span, text: &str| errors.push(span, format!("`{name}` {text}"));
    match vertex {
        Vertex::Support(_) => match inputs.len() + outputs.len() {
            1 => {}
            0 => push(vertex.span(), "holds nothing: join it to an element or a connection by an arrow"),
            _ => push(
                vertex.span(),
                "stands in the middle of a path: a support ends a path; hold a point in between by a \
                      connection, `pinned -> conn ..`",
            ),
        },
        Vertex::Element(_) => {
            match inputs.as_slice() {
                [_] => {}
                [] => push(
                    vertex.span(),
                    "has no input: its path begins in the air; begin it with a support or a connection",
                ),
                [.., last] => {
                    push(*last, "has two inputs: an element has one, paths are joined by a connection `conn`")
                }
            }
            match outputs.as_slice() {
                [_] => {}
                [] => push(
                    vertex.span(),
                    "has no output: its path ends in the air; end it with a support or a connection",
                ),
                [.., last] => push(*last, "has two outputs: every arrow leads to the one root"),
            }
        }
        Vertex::Connection(_) => {
            if inputs.is_empty() {
                push(vertex.span(), "has no input: let paths end in it");
            }
            match outputs.as_slice() {
                [_] => {}
                [] => push(vertex.span(), "has no output: lead it on towards the root"),
                [.., last] => push(*last, "has two outputs: a connection has one, every arrow leads to the one root"),
            }
        }
    }
}

/// The one support that receives an arrow.
fn find_root(graph: &Graph<'_>, errors: &mut Errors) -> Option<usize> {
    let receives = |vertex: usize| graph.edges.iter().any(|edge| edge.to == vertex);
    let roots: Vec<usize> =
        (0..graph.vertices.len()).filter(|&v| matches!(graph.vertices[v], Vertex::Support(_)) && receives(v)).collect();
    match roots.as_slice() {
        [] => {
            if let Some(vertex) = graph.vertices.first() {
                let message = "no support receives an arrow, so this model has no root: end one path with `-> support`";
                errors.push(vertex.span(), message);
            }
            None
        }
        [root] => Some(*root),
        [first, others @ ..] => {
            for other in others {
                let message =
                    "a second root: exactly one support receives an arrow; turn the arrows of this path round";
                errors.push(graph.vertices[*other].span(), message);
            }
            errors.push(graph.vertices[*first].span(), "the first root is here");
            None
        }
    }
}

/// Every vertex leads to the root; where each has one output, what does not lead there runs in a closed loop.
fn check_reach(graph: &Graph<'_>, root: usize) -> syn::Result<()> {
    let mut reached = vec![false; graph.vertices.len()];
    let mut pending = vec![root];
    while let Some(vertex) = pending.pop() {
        if !std::mem::replace(&mut reached[vertex], true) {
            pending.extend(graph.inputs(vertex));
        }
    }
    let mut errors = Errors::default();
    if let Some(lost) = (0..graph.vertices.len()).find(|&vertex| !reached[vertex]) {
        let vertex = &graph.vertices[lost];
        let message = format!("`{}` does not lead to the root: its arrows run in a closed loop", vertex.name());
        errors.push(vertex.span(), message);
    }
    errors.propagate()
}

//! Emits the labels that are names, for editors: a field for each, used wherever the label is.
//!
//! Nothing runs and nothing remains of it. But an editor that is asked for the definition of `conn arm`, or to rename it,
//! finds an item of that name with all its mentions; fields clash with no name of the user's.

use super::Names;
use crate::ast::{Label, Model, Node};
use proc_macro2::{Ident, TokenStream};
use quote::quote_spanned;
use std::collections::BTreeSet;

/// `struct Labels { arm: () }` and a function with every mention of `arm`, for elements and for connections; nothing for numbers.
pub(super) fn labels(model: &Model, names: &Names) -> TokenStream {
    let of_connections = |node: &&Node| matches!(node, Node::Connection(_));
    let (connections, elements): (Vec<&Node>, Vec<&Node>) = model.nodes().partition(of_connections);
    let [connections, elements] = [connections, elements].map(|nodes| set(&nodes, names));
    quote_spanned!(names.here=> #connections #elements)
}

/// One set of labels.
fn set(nodes: &[&Node], names: &Names) -> TokenStream {
    let mentions: Vec<(&Ident, String)> = nodes.iter().filter_map(|node| named(node)).collect();
    let mut known = BTreeSet::new();
    let definitions = mentions.iter().filter(|(label, _)| known.insert(label.to_string()));
    let fields = definitions.map(|(label, doc)| quote_spanned!(names.here=> #[doc = #doc] #label: ()));
    let uses = mentions.iter().map(|(label, _)| quote_spanned!(names.here=> let _ = labels.#label;));
    if mentions.is_empty() {
        return TokenStream::new();
    }
    quote_spanned! {names.here=>
        const _: () = {
            #[allow(dead_code, non_snake_case)]
            struct Labels { #(#fields),* }
            const _: fn(&Labels) = |labels| { #(#uses)* };
        };
    }
}

/// The label of a node and how the user calls the node.
fn named(node: &Node) -> Option<(&Ident, String)> {
    match node {
        Node::Support(_) => None,
        Node::Connection(connection) => name(&connection.label).map(|label| (label, format!(" `{connection}`"))),
        Node::Element(element) => name(&element.label).map(|label| (label, format!(" `{element}`"))),
    }
}

fn name(label: &Label) -> Option<&Ident> {
    match label {
        Label::Name(name) => Some(name),
        Label::Literal(_) => None,
    }
}

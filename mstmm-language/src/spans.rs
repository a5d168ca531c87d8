//! Places and meanings of tokens: what rustc shows, and what a name refers to.

use proc_macro2::{Span, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// The span of emitted code.
///
/// Its place is the user's token, its meaning that of `$crate`, with which most paths begin: where rustc has to join spans
/// of different meaning, it underlines something else, often the whole macro.
pub(crate) fn emitted_at(facade: &TokenStream, token: Span) -> Span {
    let facade = facade.clone().into_iter().next();
    facade.map_or_else(Span::call_site, |facade| facade.span()).located_at(token)
}

/// Where a name comes from: a macro's own `k` and that of its caller are two variables.
///
/// rustc shows this, before the place, in the debug form of a span and nowhere else on the stable channel. Should the form
/// change, the place makes all names differ, and equal elements are merely no longer shared.
pub(crate) fn origin(span: Span) -> String {
    let text = format!("{span:?}");
    text.split_once(" bytes(").map(|(context, _)| context.to_owned()).unwrap_or(text)
}

/// Tokens as text in which equal names of different origin differ.
pub(crate) fn meaning(tokens: TokenStream) -> String {
    let mut text = String::new();
    for tree in tokens {
        match tree {
            TokenTree::Ident(name) => text += &format!("{name}{} ", origin(name.span())),
            TokenTree::Group(group) => text += &format!("{:?}{{ {}}} ", group.delimiter(), meaning(group.stream())),
            other => text += &format!("{other} "),
        }
    }
    text
}

/// All names that occur in the tokens.
pub(crate) fn collect_names(tokens: TokenStream, names: &mut BTreeSet<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Ident(name) => {
                names.insert(name.to_string());
            }
            TokenTree::Group(group) => collect_names(group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

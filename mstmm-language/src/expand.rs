//! The pipeline: tokens, syntax tree, graph, checked tree, plan, code.

use crate::diagnostics::Errors;
use crate::groups::made_visible;
use crate::{check, depth, emit, parse, plan::Plan, topology::Graph};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// Expands `(path to mstmm) model` into its code, or into its errors.
pub fn expand(input: TokenStream) -> TokenStream {
    match expand_checked(input) {
        Ok(code) => code,
        Err(errors) => errors.into_compile_error(),
    }
}

/// Expands a model into its code, or returns all errors of syntax, words and graph at once.
pub(crate) fn expand_checked(input: TokenStream) -> syn::Result<TokenStream> {
    depth::check(input.clone())?;
    let mut errors = Errors::default();
    let model = parse::model(in_braces(made_visible(input)), &mut errors)?;
    check::words(&model, &mut errors);
    let derivatives = check::derivatives(&model, &mut errors);
    let graph = Graph::of(&model, &mut errors);
    let tree = check::topology(&model, &graph, errors)?;
    let plan = Plan::of(&tree);
    Ok(emit::model(&model, &plan, &derivatives))
}

/// Puts the input into braces that stand at its last token: there, and not at the whole macro, belongs what is missing at
/// the end.
fn in_braces(input: TokenStream) -> TokenStream {
    let last = input.clone().into_iter().last();
    let mut braces = Group::new(Delimiter::Brace, input);
    if let Some(last) = last {
        braces.set_span(match &last {
            TokenTree::Group(group) => group.span_close(),
            other => other.span(),
        });
    }
    TokenTree::Group(braces).into()
}

//! The pipeline: tokens, syntax tree, graph, checked tree, plan, code.

use crate::ast::Model;
use crate::groups::made_visible;
use crate::{check, emit, plan::Plan, topology::Graph};
use proc_macro2::TokenStream;

/// Expands a model into its code, or into all errors of the first stage that has any.
pub(crate) fn expand(input: TokenStream) -> TokenStream {
    match expand_checked(input) {
        Ok(code) => code,
        Err(errors) => errors.into_compile_error(),
    }
}

fn expand_checked(input: TokenStream) -> syn::Result<TokenStream> {
    let model: Model = syn::parse2(made_visible(input))?;
    check::language(&model)?;
    let graph = Graph::of(&model)?;
    let tree = check::topology(&graph)?;
    let plan = Plan::of(&tree);
    Ok(emit::model(&model, &plan))
}

//! The pipeline: tokens, syntax tree, graph, checked tree, plan, code.

use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::groups::{in_braces, made_visible};
use crate::network::{self, Network, Paths, Points};
use crate::{check, depth, emit, parse, plan::Plan, skeleton::Skeleton, topology::Graph};
use proc_macro2::TokenStream;

/// Expands `(path to mstmm) model` into its code, or into its errors.
pub fn expand(input: TokenStream) -> TokenStream {
    match expand_checked(input) {
        Ok(code) => code,
        Err(errors) => errors.into_compile_error(),
    }
}

/// Expands a model into its code, or returns all errors of syntax, words and graph at once.
pub(crate) fn expand_checked(input: TokenStream) -> syn::Result<TokenStream> {
    let mut errors = Errors::default();
    let model = read(input, &mut errors)?;
    check::words(&model, &mut errors);
    let derivatives = check::derivatives(&model, &mut errors);
    if model.is_located() {
        let network = network(&model, errors)?;
        return emit::located(&model, &network, &Skeleton::of(&network), &derivatives);
    }
    let graph = Graph::of(&model, &mut errors);
    let tree = check::topology(&model, &graph, errors)?;
    let plan = Plan::of(&tree);
    check::states(&plan)?;
    Ok(emit::model(&model, &plan, &derivatives))
}

/// Reads the tokens of a model.
pub(crate) fn read(input: TokenStream, errors: &mut Errors) -> syn::Result<Model> {
    depth::check(input.clone())?;
    parse::model(in_braces(made_visible(input)), errors)
}

/// The network of a model with locations, or all errors in it.
pub(crate) fn network(model: &Model, mut errors: Errors) -> syn::Result<Network<'_>> {
    let dimension = match check::dimension(model, &mut errors) {
        Ok(dimension) => dimension,
        Err(space) => return Err(errors.and(space)),
    };
    check::located_words(model, dimension, &mut errors);
    let graph = network::Graph::of(model, &mut errors);
    let points = Points::of(&graph);
    let paths = Paths::of(&graph, &points);
    let suspicions = check::network(model, &graph, &points, &paths, dimension, errors)?;
    Ok(Network::of(&graph, &points, &paths, dimension, suspicions))
}

//! The pipeline: tokens, syntax tree, graph, checked tree, plan, code.

use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::groups::{in_braces, made_visible};
use crate::keywords::Dimension;
use crate::network::{self, Network, Paths, Points};
use crate::{check, depth, emit, parse, parts, plan::Plan, sections, skeleton::Skeleton, topology::Graph, undamped};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

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
    let mut model = read(input.clone(), &mut errors)?;
    let Some(name) = undamped::take_name(&mut model, &mut errors) else { return code(model, errors, None) };
    let method = undamped::method(&model, &name);
    let damped = code(model, errors, None)?;
    // the same tokens again, of which all that can be wrong is known
    let mut errors = Errors::default();
    let mut model = read(input, &mut errors)?;
    undamped::take_name(&mut model, &mut errors);
    let undamped = code(model, errors, Some(&name))?;
    Ok(quote!(#damped #method #undamped))
}

/// The code of a model; given a name, of the model without what damps.
fn code(mut model: Model, mut errors: Errors, undamped: Option<&Ident>) -> syn::Result<TokenStream> {
    let mut unused = sections::spread(&mut model, &mut errors);
    if let Some(name) = undamped {
        undamped::rewrite(&mut model, name, &mut errors);
        // a section that no element has was told of the damped model
        unused.clear();
    }
    if !model.is_located() {
        let dimension = check::dimension_of_paths(&model);
        model.elements_mut().for_each(|element| element.dimension = dimension);
    }
    check::words(&model, &mut errors);
    let derivatives = check::derivatives(&model, &mut errors);
    if model.is_located() {
        let dimension = located(&mut model, &mut errors);
        let network = network(&model, dimension, errors)?;
        return emit::located(&model, &unused, &network, &Skeleton::of(&network), &derivatives);
    }
    let graph = Graph::of(&model, &mut errors);
    let tree = check::topology(&model, &graph, errors)?;
    let plan = Plan::of(&tree);
    check::states(&plan)?;
    Ok(emit::model(&model, &unused, &plan, &derivatives))
}

/// Reads the tokens of a model.
pub(crate) fn read(input: TokenStream, errors: &mut Errors) -> syn::Result<Model> {
    depth::check(input.clone())?;
    parse::model(in_braces(made_visible(input)), errors)
}

/// The dimension of a model with locations, which its elements then know.
pub(crate) fn located(model: &mut Model, errors: &mut Errors) -> Dimension {
    let dimension = check::dimension(model, errors);
    model.elements_mut().for_each(|element| element.dimension = dimension);
    parts::split(model);
    dimension
}

/// The network of a model with locations, or all errors in it.
pub(crate) fn network(model: &Model, dimension: Dimension, mut errors: Errors) -> syn::Result<Network<'_>> {
    check::located_words(model, dimension, &mut errors);
    let graph = network::Graph::of(model, &mut errors);
    let points = Points::of(&graph);
    let paths = Paths::of(&graph, &points);
    let suspicions = check::network(model, &graph, &points, &paths, dimension, errors)?;
    Ok(Network::of(&graph, &points, &paths, dimension, suspicions))
}

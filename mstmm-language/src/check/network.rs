//! The rules of models with locations.

mod arrows;
mod contacts;
mod dimension;
mod ends;
mod parts;
mod places;
mod supports;
mod words;

use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::keywords::Dimension;
use crate::network::{Graph, Paths, Points, freedoms};

pub(crate) use dimension::dimension;
pub(crate) use words::located_words;

/// Checks the graph of a model with locations, unless a line of it is missing, and ends with all errors found so far.
pub(crate) fn network(
    model: &Model,
    graph: &Graph<'_>,
    points: &Points,
    paths: &Paths,
    dimension: Dimension,
    mut errors: Errors,
) -> syn::Result<()> {
    if model.is_whole && model.elements().next().is_some() {
        ends::ends(graph, &mut errors);
        arrows::arrows(graph, points, paths, dimension, &mut errors);
        places::places(graph, points, dimension, &mut errors);
        supports::supports(graph, points, &freedoms(graph, points, paths, dimension), dimension, &mut errors);
        contacts::contacts(graph, points, paths, dimension, &mut errors);
        parts::parts(graph, &mut errors);
    }
    errors.propagate()
}

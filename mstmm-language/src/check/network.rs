//! The rules of models with locations.

mod arrows;
mod contacts;
mod dimension;
mod ends;
mod findings;
mod in_space;
mod parts;
mod places;
mod supports;
mod words;

use crate::ast::Model;
use crate::diagnostics::Errors;
use crate::keywords::Dimension;
use crate::network::{Graph, Paths, Points, Suspicion, freedoms};
use findings::Findings;

pub(crate) use dimension::dimension;
pub(crate) use words::located_words;

/// Checks the graph of a model with locations, unless a line of it is missing, and ends with all errors found so far, or with what rustc
/// alone can tell.
pub(crate) fn network<'a>(
    model: &Model,
    graph: &Graph<'a>,
    points: &Points,
    paths: &Paths<'a>,
    dimension: Dimension,
    mut errors: Errors,
) -> syn::Result<Vec<Suspicion<'a>>> {
    if !model.is_whole || model.elements().next().is_none() {
        errors.propagate()?;
        return Ok(Vec::new());
    }
    ends::ends(graph, &mut errors);
    arrows::arrows(graph, points, paths, dimension, &mut errors);
    places::places(graph, points, dimension, &mut errors);
    let mut findings = Findings { errors, suspicions: Vec::new() };
    supports::supports(graph, points, &freedoms(graph, points, paths, dimension), dimension, &mut findings);
    contacts::contacts(graph, points, paths, dimension, &mut findings);
    let Findings { mut errors, suspicions } = findings;
    parts::parts(graph, &mut errors);
    errors.propagate()?;
    Ok(suspicions)
}

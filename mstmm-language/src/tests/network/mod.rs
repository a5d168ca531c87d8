//! Models with locations: their messages, and the networks that they are.

mod accepted;
mod contacts;
mod grammar;
mod in_space;
mod joints;
mod own;
mod places;
mod supports;
mod words;

use super::{assert_refused, input};
use crate::diagnostics::Errors;
use crate::expand::{located, network, read};

/// The network of a model, as text.
#[track_caller]
fn described(model: &str) -> String {
    let mut errors = Errors::default();
    let mut model = read(input(model), &mut errors).unwrap();
    crate::check::words(&model, &mut errors);
    let dimension = located(&mut model, &mut errors);
    match network(&model, dimension, errors) {
        Ok(network) => network.to_string(),
        Err(error) => error.into_iter().map(|error| format!("{error}\n")).collect(),
    }
}

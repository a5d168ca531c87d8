//! The rules of the language, each with a message at the user's tokens.

mod derivatives;
mod fields;
mod neighbours;
mod network;
mod new_words;
mod parameters;
mod planar;
mod selves;
mod spin;
mod states;
mod tree;
mod words;

pub(crate) use derivatives::{Derivatives, derivatives};
pub(crate) use network::{dimension, located_words, network};
pub(crate) use planar::dimension_of_paths;
pub(crate) use states::states;
pub(crate) use tree::{Tree, topology};
pub(crate) use words::{is_doubtful, words};

/// Words for a message: `a`, `b` and `c`.
pub(crate) fn listed<'a>(words: impl IntoIterator<Item = &'a str>) -> String {
    let mut words: Vec<String> = words.into_iter().map(|word| format!("`{word}`")).collect();
    let last = words.pop().unwrap_or_default();
    if words.is_empty() { last } else { format!("{} and {last}", words.join(", ")) }
}

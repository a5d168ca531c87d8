//! The rules of the language, each with a message at the user's tokens.

mod language;
mod tree;

pub(crate) use language::language;
pub(crate) use tree::{Tree, topology};

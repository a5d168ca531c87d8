//! The language of `mstmm::system!`: tokens of a model in, Rust code out.
//!
//! This crate is an implementation detail of `mstmm`; the language is described there. It stands apart from the procedural
//! macro so that tests, benchmarks and fuzzers can call it: a macro crate exports nothing else.
#![forbid(unsafe_code)]

mod ast;
mod check;
mod depth;
mod diagnostics;
mod emit;
mod expand;
mod groups;
mod keywords;
mod network;
mod parse;
mod parts;
mod plan;
mod sections;
mod skeleton;
mod spans;
#[cfg(test)]
mod tests;
mod topology;
mod undamped;

pub use expand::expand;
pub use mstmm_plan::Space;

/// The elements of models without places, for tests and fuzzers: keyword, space of the states, names of the parameters that it must have, of
/// those that it may have, and of those of which it has one.
pub fn elements() -> impl Iterator<Item = (&'static str, Space, [&'static [&'static str]; 3])> {
    let parameters = |row: &keywords::Keyword| [row.required, row.optional, row.one_of];
    keywords::elements_of_paths().map(move |row| (row.name, row.space, parameters(row)))
}

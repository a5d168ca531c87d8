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
mod parse;
mod plan;
mod spans;
#[cfg(test)]
mod tests;
mod topology;

pub use expand::expand;

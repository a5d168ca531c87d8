//! The procedural macro behind `mstmm::system!`.
//!
//! This crate is an implementation detail of `mstmm`; its language is described there.
#![forbid(unsafe_code)]

mod ast;
mod check;
mod diagnostics;
mod emit;
mod expand;
mod groups;
mod keywords;
mod parse;
mod plan;
#[cfg(test)]
mod tests;
mod topology;

use proc_macro::TokenStream;

/// Expands `(path to mstmm) model`; called by `mstmm::system!` alone, which knows the path.
#[doc(hidden)]
#[proc_macro]
pub fn expand_system(input: TokenStream) -> TokenStream {
    expand::expand(input.into()).into()
}

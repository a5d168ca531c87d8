//! The models written by hand or in advance: those of the paper and random ones that other tests compile.
#![expect(clippy::panic, reason = "a source that is no Rust is shown")]

#[path = "models_in.rs"]
mod models_in;

use models_in::models_in;
use proc_macro2::TokenStream;

const SOURCES: [&str; 3] = [
    include_str!("../../../examples/paper/src/models.rs"),
    include_str!("../../../tests/support/undamped_models.rs"),
    include_str!("../../../tests/support/damped_models.rs"),
];

/// What stands in each `system!` of the sources; the five of the paper first.
///
/// # Panics
/// If a source is no Rust.
pub(crate) fn written_models() -> Vec<TokenStream> {
    let models = |source: &&str| match models_in(source) {
        Ok(models) => models,
        Err(error) => panic!("{error}"),
    };
    SOURCES.iter().flat_map(models).collect()
}

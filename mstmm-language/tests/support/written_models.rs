//! The models written by hand or in advance: those of the paper and random ones that other tests compile.
#![expect(clippy::panic, reason = "a source that is no Rust is shown")]

use proc_macro2::TokenStream;
use syn::Item;

const SOURCES: [&str; 3] = [
    include_str!("../../../examples/paper/models.rs"),
    include_str!("../../../tests/support/undamped_models.rs"),
    include_str!("../../../tests/support/damped_models.rs"),
];

/// What stands in each `system!` of the sources; the five of the paper first.
///
/// # Panics
/// If a source is no Rust.
pub(crate) fn written_models() -> Vec<TokenStream> {
    let files = SOURCES.iter().map(|source| match syn::parse_file(source) {
        Ok(file) => file,
        Err(error) => panic!("{error}"),
    });
    let model = |item| match item {
        Item::Macro(item) if item.mac.path.is_ident("system") => Some(item.mac.tokens),
        _ => None,
    };
    files.flat_map(|file| file.items).filter_map(model).collect()
}

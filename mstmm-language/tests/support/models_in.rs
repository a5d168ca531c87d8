//! The models of a source file.

use proc_macro2::TokenStream;
use syn::Item;

/// What stands in each `system!` of a source.
///
/// # Errors
/// The source is no Rust.
pub(crate) fn models_in(source: &str) -> syn::Result<Vec<TokenStream>> {
    let model = |item| match item {
        Item::Macro(item) if item.mac.path.is_ident("system") => Some(item.mac.tokens),
        _ => None,
    };
    Ok(syn::parse_file(source)?.items.into_iter().filter_map(model).collect())
}

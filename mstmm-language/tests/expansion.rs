//! The code of a small damped model and of one with places as the macro emits it, kept as files, so that a change of it is seen.
//!
//! Written anew by `UPDATE_EXPECT=1 cargo test -p mstmm-language --test expansion`; `tests/language/expansion.rs` of the workspace
//! compiles it.

use expect_test::expect_file;
use proc_macro2::TokenStream;

#[path = "support/models_in.rs"]
mod models_in;

/// The model of a source, expanded and formatted.
fn expanded(source: &str) -> syn::Result<String> {
    let facade: TokenStream = syn::parse_str("(mstmm)")?;
    let model = models_in::models_in(source)?.into_iter().flatten();
    let code = mstmm_language::expand(facade.into_iter().chain(model).collect());
    Ok(prettyplease::unparse(&syn::parse2(code)?))
}

#[test]
fn the_code_of_a_model_is_what_it_was() {
    expect_file!["expansion/expanded.rs"].assert_eq(&expanded(include_str!("expansion/model.rs")).unwrap());
}

#[test]
fn the_code_of_a_model_with_places_is_what_it_was() {
    let model = include_str!("expansion/located_model.rs");
    expect_file!["expansion/located_expanded.rs"].assert_eq(&expanded(model).unwrap());
}

//! The code of a small damped model as the macro emits it, kept as a file, so that a change of it is seen.
//!
//! Written anew by `UPDATE_EXPECT=1 cargo test -p mstmm-language --test expansion`; `tests/language/expansion.rs` of the workspace
//! compiles it.

use expect_test::expect_file;
use proc_macro2::TokenStream;

#[path = "support/models_in.rs"]
mod models_in;

/// The model, expanded and formatted.
fn expanded() -> syn::Result<String> {
    let facade: TokenStream = syn::parse_str("(mstmm)")?;
    let model = models_in::models_in(include_str!("expansion/model.rs"))?.into_iter().flatten();
    let code = mstmm_language::expand(facade.into_iter().chain(model).collect());
    Ok(prettyplease::unparse(&syn::parse2(code)?))
}

#[test]
fn the_code_of_a_model_is_what_it_was() {
    expect_file!["expansion/expanded.rs"].assert_eq(&expanded().unwrap());
}

//! The code of the five examples as the macro emits it, kept as files, so that a change of it is seen.
//!
//! Written anew by `UPDATE_EXPECT=1 cargo test --test expansions`; `expansions_compiled.rs` compiles it.

use expect_test::{ExpectFile, expect_file};
use proc_macro2::TokenStream;

#[path = "../mstmm-language/tests/support/models_in.rs"]
mod models_in;

/// The models of the example, each expanded and formatted.
fn expanded() -> syn::Result<Vec<String>> {
    let facade: TokenStream = syn::parse_str("(mstmm)")?;
    let models = models_in::models_in(include_str!("../examples/paper/src/models.rs"))?;
    let code =
        models.into_iter().map(|model| mstmm_language::expand(facade.clone().into_iter().chain(model).collect()));
    code.map(|code| Ok(prettyplease::unparse(&syn::parse2(code)?))).collect()
}

#[test]
fn the_code_of_the_examples_is_what_it_was() {
    let files: [ExpectFile; 5] = [
        expect_file!["expansions/tip_body.rs"],
        expect_file!["expansions/restrained_beam.rs"],
        expect_file!["expansions/spring_and_mass.rs"],
        expect_file!["expansions/two_spans.rs"],
        expect_file!["expansions/damped_oscillator.rs"],
    ];
    let expanded = expanded().unwrap();
    assert_eq!(expanded.len(), files.len());
    for (file, code) in files.iter().zip(expanded) {
        file.assert_eq(&code);
    }
}

//! Mutations of valid models, of a random one or of one that is written somewhere: the bytes are the choices.
#![no_main]

#[path = "../../mstmm-language/tests/support/choices.rs"]
mod choices;
#[path = "../../mstmm-language/tests/support/mutations.rs"]
mod mutations;
#[path = "../../mstmm-language/tests/support/properties.rs"]
mod properties;
#[path = "../../mstmm-language/tests/support/valid_models.rs"]
mod valid_models;
#[path = "../../mstmm-language/tests/support/words.rs"]
mod words;
#[path = "../../mstmm-language/tests/support/written_models.rs"]
mod written_models;

use choices::Choices;
use libfuzzer_sys::fuzz_target;
use mutations::mutated;
use proc_macro2::{TokenStream, TokenTree};
use properties::expanded;
use valid_models::valid_model;
use words::words;
use written_models::written_models;

thread_local! {
    static WRITTEN: Vec<TokenStream> = written_models();
    static WORDS: Vec<Vec<TokenTree>> = words();
}

fuzz_target!(|bytes: &[u8]| {
    // the first byte says how many of the others write the model: none for a written one
    let Some((&length, bytes)) = bytes.split_first() else { return };
    let (writing, mutating) = bytes.split_at(bytes.len().min(usize::from(length)));
    let mut choices = Choices(mutating);
    WRITTEN.with(|written| {
        let model = match length {
            0 => written[choices.below(written.len())].clone(),
            _ => valid_model(&mut Choices(writing)).parse().expect("valid models lex"),
        };
        let is_mutated = !choices.is_empty();
        let model = WORDS.with(|words| mutated(model, written, words, &mut choices));
        let errors = expanded(model);
        assert!(is_mutated || errors.is_empty(), "a valid model is refused: {errors:?}");
    });
});

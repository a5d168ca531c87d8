//! Mutations of valid models, of a random one or of one that is written somewhere: the bytes are the choices.
#![no_main]

#[path = "../../../mstmm-language/tests/support/choices.rs"]
mod choices;
#[path = "../../../mstmm-language/tests/support/mutations.rs"]
mod mutations;
#[path = "../../../mstmm-language/tests/support/properties.rs"]
mod properties;
#[path = "../../../mstmm-language/tests/support/valid_models.rs"]
mod valid_models;
#[path = "../../../mstmm-language/tests/support/words.rs"]
mod words;
#[path = "../../../mstmm-language/tests/support/written_models.rs"]
mod written_models;

use choices::Choices;
use libfuzzer_sys::fuzz_target;
use mutations::{Flat, flat, mutated};
use proc_macro2::{TokenStream, TokenTree};
use properties::expanded;
use valid_models::valid_model;
use words::words;
use written_models::written_models;

thread_local! {
    static WRITTEN: Vec<TokenStream> = written_models();
    static FLAT: Vec<Vec<Flat>> = written_models().into_iter().map(flat).collect();
    static WORDS: Vec<Vec<TokenTree>> = words();
}

/// Most bytes that write a model: small ones are tried faster and have the same mistakes.
const WRITING: usize = 24;

fuzz_target!(|bytes: &[u8]| {
    // the first byte says how many of the others write the model: none for a written one
    let Some((&first, bytes)) = bytes.split_first() else { return };
    let (writing, mutating) = bytes.split_at(bytes.len().min(usize::from(first) % WRITING));
    let mut choices = Choices(mutating);
    let model = match writing {
        [] => WRITTEN.with(|written| written[choices.below(written.len())].clone()),
        _ => valid_model(&mut Choices(writing)).parse().expect("a valid model lexes"),
    };
    let is_mutated = !choices.is_empty();
    let model = FLAT.with(|others| WORDS.with(|words| mutated(model, others, words, &mut choices)));
    let errors = expanded(model);
    assert!(is_mutated || errors.is_empty(), "a valid model is refused: {errors:?}");
});

//! Any text that lexes, as a model.
#![no_main]

#[path = "../../../mstmm-language/tests/support/properties.rs"]
mod properties;

use libfuzzer_sys::fuzz_target;
use proc_macro2::TokenStream;
use properties::{expanded, expanded_twice};

fuzz_target!(|text: &str| {
    if let Ok(model) = text.parse::<TokenStream>() {
        expanded_twice(model.clone());
        expanded(model);
    }
});

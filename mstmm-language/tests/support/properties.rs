//! What holds of the expansion of any tokens whatever; the tests and the fuzzer share this file.
#![expect(clippy::panic, reason = "a finding is a panic")]

use mstmm_language::expand;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::{ToTokens, format_ident};
use syn::{File, Item};

/// Expands a model as `mstmm::system!` does, with the path to the facade before it: its errors, none if it is accepted.
///
/// # Panics
/// If the macro does, or if what it emits is neither code that parses, with the model's struct and its system in it, nor
/// errors with a text, or if a second expansion differs.
pub(crate) fn expanded(model: TokenStream) -> Vec<String> {
    let facade = Group::new(Delimiter::Parenthesis, format_ident!("mstmm").into_token_stream());
    let input: TokenStream = std::iter::once(TokenTree::from(facade)).chain(model).collect();
    let output = expanded_twice(input);
    let file: File = match syn::parse2(output.clone()) {
        Ok(file) => file,
        Err(error) => panic!("the output does not parse, {error}:\n{output}"),
    };
    let errors: Vec<String> = file.items.iter().filter_map(message).collect();
    if errors.is_empty() {
        assert!(defines_a_system(&file), "neither a system nor an error:\n{output}");
        return errors;
    }
    assert_eq!(errors.len(), file.items.len(), "errors with something else:\n{output}");
    assert!(errors.iter().all(|message| !message.trim().is_empty()), "an error without text:\n{output}");
    errors
}

/// Expands any tokens, with or without what `mstmm::system!` puts before them.
///
/// # Panics
/// If the macro does, or if a second expansion differs.
pub(crate) fn expanded_twice(input: TokenStream) -> TokenStream {
    let output = expand(input.clone());
    assert_eq!(output.to_string(), expand(input).to_string(), "two expansions differ");
    output
}

/// Text of a `compile_error!`.
fn message(item: &Item) -> Option<String> {
    match item {
        Item::Macro(item) if item.mac.path.segments.last()?.ident == "compile_error" => {
            Some(item.mac.parse_body::<syn::LitStr>().map_or_else(|_| String::new(), |text| text.value()))
        }
        _ => None,
    }
}

/// Whether the items begin with a model's struct, and its system is one of them.
fn defines_a_system(file: &File) -> bool {
    let mut structs = file.items.iter().filter_map(|item| match item {
        Item::Struct(item) => Some(item.ident.clone()),
        _ => None,
    });
    structs.next().is_some_and(|model| structs.any(|system| system == format_ident!("{}System", model)))
}

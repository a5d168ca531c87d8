//! The macro survives any tokens: errors come out, or code that parses, and the same ones each time.
#![expect(clippy::unwrap_used, reason = "what is written here lexes")]

#[path = "support/cases.rs"]
mod cases;
#[path = "support/properties.rs"]
mod properties;
#[path = "support/words.rs"]
mod words;

use cases::cases;
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use properties::{expanded, expanded_twice};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;
use words::words;

/// Beginnings of a model, so that random tokens come where they are read as a field, a line, a node or a parameter.
const BEGINNINGS: [&str; 10] = [
    "",
    "struct M;",
    "struct M { k: f64 } let a = ",
    "struct M; fixed ->",
    "struct M; fixed -> spring",
    "struct M; fixed -> spring 1 { stiffness: 1.0 } -> conn 2; conn 2",
    "#[derive(Clone)] struct M",
    "struct M; fixed at",
    "struct M; fixed at (0.0, 0.0) -> pin 1 {} -> conn 2 <- along",
    "struct M; held(x) at (0.0, 0.0) -> conn 1; conn 1",
];

/// Places for a group of random tokens in an otherwise valid model.
const SURROUNDINGS: [(&str, &str); 4] = [
    ("struct M", "fixed -> spring 1 { stiffness: 1.0 } -> free;"),
    ("struct M; fixed -> spring 1", "-> free;"),
    ("struct M; let k = f", "; fixed -> spring 1 { stiffness: k } -> free;"),
    ("#", "struct M; fixed -> spring 1 { stiffness: 1.0 } -> free;"),
];

fn tokens(text: &str) -> TokenStream {
    text.parse().unwrap()
}

fn literal() -> impl Strategy<Value = Literal> {
    prop_oneof![
        any::<u128>().prop_map(Literal::u128_unsuffixed),
        any::<i64>().prop_map(Literal::i64_suffixed),
        any::<u8>().prop_map(Literal::u8_suffixed),
        any::<f64>().prop_filter("finite", |x| x.is_finite()).prop_map(Literal::f64_unsuffixed),
        any::<f32>().prop_filter("finite", |x| x.is_finite()).prop_map(Literal::f32_suffixed),
        any::<char>().prop_map(Literal::character),
        any::<String>().prop_map(|text| Literal::string(&text)),
        vec(any::<u8>(), 0..4).prop_map(|bytes| Literal::byte_string(&bytes)),
    ]
}

/// One or a few tokens: a word of the dictionary, a name in any script, a literal.
fn word() -> impl Strategy<Value = Vec<TokenTree>> {
    let name = |text: String| vec![TokenTree::from(Ident::new(&text, Span::call_site()))];
    prop_oneof![
        12 => select(words()),
        1 => "[a-zA-Z_\\p{XID_Start}--[\\p{Mn}]]{1,4}x".prop_filter("a name", |text| syn::parse_str::<syn::Ident>(text).is_ok()).prop_map(name),
        2 => literal().prop_map(|literal| vec![literal.into()]),
    ]
}

/// A stream of words and groups of every kind, invisible ones included.
fn stream() -> impl Strategy<Value = TokenStream> {
    let row = vec(word(), 0..12).prop_map(|words| words.concat().into_iter().collect::<TokenStream>());
    row.prop_recursive(5, 60, 6, |inner| {
        let delimiter = select(vec![Delimiter::None, Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket]);
        let group = (delimiter, inner).prop_map(|(delimiter, inner)| vec![Group::new(delimiter, inner).into()]);
        vec(prop_oneof![word(), group], 0..8).prop_map(|parts| parts.concat().into_iter().collect())
    })
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn random_tokens_are_survived(beginning in select(&BEGINNINGS[..]), rest in stream()) {
        expanded(tokens(beginning).into_iter().chain(rest).collect());
    }

    #[test]
    fn random_tokens_in_a_model_are_survived(
        (before, behind) in select(&SURROUNDINGS[..]),
        delimiter in select(vec![Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket]),
        inner in stream(),
    ) {
        let group = TokenTree::from(Group::new(delimiter, inner));
        expanded(tokens(before).into_iter().chain([group]).chain(tokens(behind)).collect());
    }

    /// Whoever calls the macro without its wrapper gets an error, too.
    #[test]
    fn input_without_a_facade_is_survived(input in stream()) {
        expanded_twice(input);
    }

    #[test]
    fn random_text_is_survived(text in "(struct M;)?([a-z0-9:;,.<>{}()\\[\\]#'\"|&*!=/ \n-]|->|<-|\\PC){0,40}") {
        if let Ok(input) = text.parse() {
            expanded(input);
        }
    }
}

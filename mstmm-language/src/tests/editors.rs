//! What editors rely on: emitted items carry the user's own tokens.

use super::input;
use crate::expand::expand;
use proc_macro2::{LineColumn, TokenStream, TokenTree};

const MODEL: &str = "
pub struct Crane { mast: f64, ei: f64, m: f64, k: f64 }
let half = 0.5 * mast;
fixed -> beam lower { length: half, bending_stiffness: ei, mass_per_length: m } -> conn joint
      -> beam upper { length: half, bending_stiffness: ei, mass_per_length: m } -> conn tip -> free;
conn joint <- spring Stay { stiffness: k } <- fixed;
free -> mass load { mass: m } -> conn tip
";

/// Each name in the tokens, with its place.
fn names(tokens: TokenStream) -> Vec<(String, LineColumn)> {
    let mut names = Vec::new();
    for tree in tokens {
        match tree {
            TokenTree::Ident(name) => names.push((name.to_string(), name.span().start())),
            TokenTree::Group(group) => names.extend(self::names(group.stream())),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
    names
}

/// Every field, parameter, variable and label of the model occurs in the code as the token that the user wrote. Words of
/// the language do not: editors show for them what stands at their place, the type behind a keyword.
#[test]
fn the_users_own_tokens_are_emitted() {
    let emitted = names(expand(input(MODEL)));
    let words = ["fixed", "free", "beam", "spring", "mass", "conn"];
    let written = names(input(MODEL)).into_iter().skip(1);
    let missing: Vec<_> = written.filter(|name| !emitted.contains(name)).map(|(name, _)| name).collect();
    let missing: Vec<&str> = missing.iter().map(String::as_str).filter(|name| !words.contains(name)).collect();
    assert_eq!(missing, [""; 0]);
}

/// The type behind `beam` stands at the word `beam`, so that its documentation is shown there.
#[test]
fn the_type_of_an_element_stands_at_its_keyword() {
    let written = names(input(MODEL));
    let emitted = names(expand(input(MODEL)));
    for (keyword, type_name) in [("beam", "Beam"), ("spring", "Spring"), ("mass", "Mass")] {
        let (_, place) = written.iter().find(|(name, _)| name == keyword).unwrap();
        assert!(emitted.contains(&(type_name.to_owned(), *place)), "{keyword}");
    }
}

/// One definition of a label, with its documentation, and every mention.
#[test]
fn a_label_is_defined_once_and_used_wherever_it_is_mentioned() {
    let code = expand(input(MODEL)).to_string();
    assert!(code.contains("# [doc = \" `conn joint`\"] joint : () ,"), "{code}");
    assert_eq!(code.matches("joint : ()").count(), 1);
    assert_eq!(code.matches("let _ = labels . joint").count(), 2);
    assert_eq!(code.matches("let _ = labels . Stay").count(), 1);
}

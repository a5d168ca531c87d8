//! Elements in the words that stand for their own.

use crate::ast::{Element, Parameter};
use crate::keywords::{OldWord, has_somewhere};
use quote::ToTokens;
use syn::Expr;
use syn::ext::IdentExt;

/// The answer to an old word: the element in the new word. It has the expressions of the user, and `..` for each parameter that is missing.
/// `known` are the parameters of the new word: those that must be named, and those that may be.
pub(super) fn in_new_words(element: &Element, word: &OldWord, known: &[Vec<&'static str>; 2]) -> String {
    let new = match &element.parameters {
        // a second mention, or a slip of which the new word speaks
        None => format!("{} {}", word.new, element.label),
        Some(_) => {
            let written = parameters(element, word, known);
            let braces = if written.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", written.join(", ")) };
            format!("{} {} {braces}", word.new, element.label)
        }
    };
    format!("`{}` is `{}` now: write `{new}`", word.name, word.new)
}

/// What stands in the braces of the new form.
fn parameters(element: &Element, word: &OldWord, known: &[Vec<&'static str>; 2]) -> Vec<String> {
    let is_here = |name: &str| known.iter().flatten().any(|known| *known == name);
    let (mut written, mut named) = (Vec::new(), Vec::new());
    for parameter in element.parameters() {
        let (old, value) = (parameter.name.unraw().to_string(), value_of(parameter));
        let new = word.new_name(&old).to_owned();
        if named.contains(&new) {
            continue;
        }
        let text = match &parameter.section {
            Some(section) => Some(format!("..{section}")),
            // what the word has elsewhere means nothing here; what it has nowhere is a slip, of which the new word speaks
            None => word
                .parameter(&old, &value)
                .filter(|_| is_here(&new) || new != "length" && !has_somewhere(word.new, &new)),
        };
        written.extend(text.filter(|text| !written.contains(text)));
        named.push(new);
    }
    written.extend(element.spread.iter().map(|section| format!("..{section}")));
    let missing = known[0].iter().chain(word.needs.iter().filter(|name| is_here(name)));
    for name in missing.filter(|_| element.spread.is_empty()) {
        if !named.iter().any(|other| other == name) {
            written.push(format!("{name}: .."));
            named.push((*name).to_owned());
        }
    }
    written
}

/// The expression of a parameter, or the variable of its name.
pub(super) fn value_of(parameter: &Parameter) -> String {
    parameter.value.as_ref().map_or_else(|| parameter.name.to_string(), text_of)
}

/// An expression as it is usually written.
fn text_of(value: &Expr) -> String {
    let text = value.to_token_stream().to_string();
    let text = text.strip_prefix("- ").map_or_else(|| text.clone(), |rest| format!("-{rest}"));
    [(" . ", "."), (" :: ", "::"), (" (", "("), ("( ", "("), (" )", ")"), (" ,", ","), ("(- ", "(-"), (", - ", ", -")]
        .into_iter()
        .fold(text, |text, (from, to)| text.replace(from, to))
}

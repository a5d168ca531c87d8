//! Elements in the words that stand for their own.

use crate::ast::Element;
use crate::keywords::OldWord;
use quote::ToTokens;
use syn::Expr;
use syn::ext::IdentExt;

/// What an old word is answered with: the element in the word that stands for it, with the expressions of the user for what that has, and
/// what it lacks. The parameters of that word are those that must be named, and those that may be.
pub(super) fn in_new_words(element: &Element, word: &OldWord, known: &[Vec<&'static str>; 2]) -> String {
    let name_of = |parameter: &str| parameter.split_once(':').map_or(parameter, |(name, _)| name).to_owned();
    let given = element.parameters().filter_map(|parameter| {
        let value = parameter.value.as_ref().map_or_else(|| parameter.name.to_string(), text_of);
        word.parameter(&parameter.name.unraw().to_string(), &value)
    });
    let is_known = |parameter: &String| known.iter().flatten().any(|name| *name == name_of(parameter));
    let mut parameters: Vec<String> = given.filter(is_known).collect();
    let named: Vec<String> = parameters.iter().map(|parameter| name_of(parameter)).collect();
    let missing = known[0].iter().filter(|name| !named.iter().any(|other| other == *name));
    parameters.extend(missing.map(|name| format!("{name}: ..")));
    let braces = if parameters.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", parameters.join(", ")) };
    format!("`{}` is `{}` now: write `{} {} {braces}`", word.name, word.new, word.new, element.label)
}

/// An expression as it is usually written.
fn text_of(value: &Expr) -> String {
    let text = value.to_token_stream().to_string();
    text.replace(" . ", ".").replace(" :: ", "::").replace(" (", "(").replace("( ", "(").replace(" )", ")")
}

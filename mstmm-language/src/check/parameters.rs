//! The parameters of an element: each must be given once, and no others.

use super::listed;
use crate::ast::Element;
use crate::diagnostics::Errors;
use crate::keywords::nearest;
use std::collections::BTreeSet;
use syn::ext::IdentExt;

/// Checks the parameters of one element against those that it must have, and those of them that may be left out. For a type of the user it
/// only checks that each is given once, since rustc knows which.
pub(super) fn parameters(element: &Element, known: Option<[&'static [&'static str]; 2]>, errors: &mut Errors) {
    let mut given = BTreeSet::new();
    for parameter in element.parameters() {
        if !given.insert(parameter.name.unraw().to_string()) {
            errors.push(
                parameter.name.span(),
                format!("`{element}` gives `{}` a second time: remove one of the two", parameter.name),
            );
        }
    }
    let Some([known, optional]) = known else { return };
    let is_missing = |name: &&str| !given.contains(*name) && !optional.contains(name);
    let mut missing: Vec<&str> = known.iter().copied().filter(is_missing).collect();
    let is_unknown = |name: &str| !known.contains(&name);
    let is_only_one = given.iter().filter(|name| is_unknown(name)).count() == 1 && missing.len() == 1;
    for parameter in element.parameters() {
        let name = parameter.name.unraw().to_string();
        if !is_unknown(&name) {
            continue;
        }
        let meant = nearest(missing.iter().copied(), &name).or(missing.first().copied().filter(|_| is_only_one));
        let hint = match meant {
            Some(meant) => {
                missing.retain(|other| *other != meant);
                format!("did you mean `{meant}`?")
            }
            None => format!("it has {}", listed(known.iter().copied())),
        };
        errors.push(parameter.name.span(), format!("`{}` has no parameter `{name}`: {hint}", element.kind.name()));
    }
    if !missing.is_empty() {
        errors.push(element.place(), format!("`{element}` lacks {}", listed(missing)));
    }
}

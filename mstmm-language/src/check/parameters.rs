//! The parameters of an element: each must be given once, and no others.

use super::listed;
use crate::ast::Element;
use crate::diagnostics::Errors;
use crate::keywords::{DAMPING, nearest};
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
    let selecting = element.kind.known().and_then(|row| row.variant).map_or(&[][..], |variant| variant.parameters);
    let is_unknown = |name: &str| !known.contains(&name) && !selecting.contains(&name);
    let is_only_one = given.iter().filter(|name| is_unknown(name)).count() == 1 && missing.len() == 1;
    for parameter in element.parameters() {
        let name = parameter.name.unraw().to_string();
        if !is_unknown(&name) {
            continue;
        }
        let candidates = missing.iter().chain(selecting).copied();
        let meant = nearest(candidates, &name).or(missing.first().copied().filter(|_| is_only_one));
        let hint = match meant {
            _ if DAMPING.contains(&name.as_str()) => advice_on_damping(selecting),
            Some(meant) => {
                missing.retain(|other| *other != meant);
                format!("did you mean `{meant}`?")
            }
            None => format!("it has {}", listed(known.iter().chain(selecting).copied())),
        };
        errors.push(parameter.name.span(), format!("`{}` has no parameter `{name}`: {hint}", element.kind.name()));
    }
    if !missing.is_empty() {
        errors.push(element.place(), format!("`{element}` lacks {}", listed(missing)));
    }
}

/// Advice for a parameter of damping that an element does not take, given those that it takes.
fn advice_on_damping(taken: &[&str]) -> String {
    if taken.is_empty() {
        return "springs, torsion springs, uniform beams, rods and shafts have damping of their own, strings an external one"
            .to_owned();
    }
    format!("of damping it has {}", listed(taken.iter().copied()))
}

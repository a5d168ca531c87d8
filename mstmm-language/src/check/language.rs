//! Rules that need no graph: the struct, keywords, parameters.

use crate::ast::{Element, Kind, Model, Node};
use crate::diagnostics::Errors;
use crate::keywords::{CONNECTION, ELEMENTS, SUPPORTS, look_up, nearest};
use std::collections::BTreeSet;
use syn::spanned::Spanned;
use syn::{Fields, Ident, Type};

/// Checks all that one node or one field shows by itself.
pub(crate) fn language(model: &Model) -> syn::Result<()> {
    let mut errors = Errors::default();
    check_struct(model, &mut errors);
    for node in model.nodes() {
        match node {
            Node::Support(keyword) => check_support(keyword, &mut errors),
            Node::Connection(_) => {}
            Node::Element(element) => check_element(element, model, &mut errors),
        }
    }
    // a misspelt element may be the one that is missing
    if errors.is_empty() && model.elements().next().is_none() {
        let message = "this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`";
        errors.push(model.parameters.ident.span(), message);
    }
    errors.propagate()
}

/// The struct of parameters has named fields of type `f64` and no generics.
fn check_struct(model: &Model, errors: &mut Errors) {
    let item = &model.parameters;
    for attribute in item.attrs.iter().filter(|attribute| attribute.path().is_ident("cfg")) {
        errors.add(syn::Error::new_spanned(
            attribute,
            "write `#[cfg(..)]` before `system!`: it is about the whole model",
        ));
    }
    if !item.generics.params.is_empty() {
        let message = "the struct of a model takes no generic parameters: its fields are all `f64`";
        errors.add(syn::Error::new_spanned(&item.generics, message));
    }
    match &item.fields {
        Fields::Named(fields) => {
            for field in &fields.named {
                if !matches!(&field.ty, Type::Path(path) if path.path.is_ident("f64")) {
                    let message = "a field of a model is an `f64`: compute anything else in a `let` line";
                    errors.add(syn::Error::new_spanned(&field.ty, message));
                }
            }
        }
        Fields::Unit => {}
        Fields::Unnamed(fields) => {
            let message = "the struct of a model has named fields, `struct Model { length: f64, .. }`";
            errors.push(fields.span(), message);
        }
    }
}

/// A word that stands alone is a support.
fn check_support(keyword: &Ident, errors: &mut Errors) {
    let text = keyword.to_string();
    if look_up(SUPPORTS, &text).is_some() {
        return;
    }
    if look_up(ELEMENTS, &text).is_some() {
        errors.push(keyword.span(), format!("`{text}` needs a label and parameters, `{text} 1 {{ .. }}`"));
        return;
    }
    let word = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let hint = if word != text && (word == CONNECTION || look_up(ELEMENTS, word).is_some()) {
        format!("put a space before the label, `{word} {}`", &text[word.len()..])
    } else {
        match nearest(SUPPORTS.iter().map(|(name, _)| *name), &text) {
            Some(name) => format!("did you mean `{name}`?"),
            None => format!("the supports are {}", list(SUPPORTS)),
        }
    };
    errors.push(keyword.span(), format!("`{text}` is not a support: {hint}"));
}

/// An element has a known keyword and its parameters, each once.
fn check_element(element: &Element, model: &Model, errors: &mut Errors) {
    let unknown = match &element.kind {
        Kind::Keyword(keyword) => unknown_keyword(keyword),
        Kind::Type(_) => None,
    };
    if let Some(message) = unknown {
        errors.push(element.kind.place(), message);
    } else if element.parameters.is_none() {
        errors.push(element.place(), without_parameters(element, model));
    }
    let mut seen = BTreeSet::new();
    for parameter in element.parameters() {
        if !seen.insert(parameter.name.to_string()) {
            errors.push(parameter.name.span(), format!("`{element}` gives `{}` twice", parameter.name));
        }
    }
}

/// What is wrong with the keyword of an element, if anything is.
fn unknown_keyword(keyword: &Ident) -> Option<String> {
    let text = keyword.to_string();
    if look_up(ELEMENTS, &text).is_some() {
        return None;
    }
    if look_up(SUPPORTS, &text).is_some() {
        return Some(format!("the support `{text}` takes no label and no parameters"));
    }
    let known = ELEMENTS.iter().map(|(name, _)| *name).chain([CONNECTION]);
    let hint = match nearest(known, &text) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the elements are {}, or a type of your own by a path with `::`", list(ELEMENTS)),
    };
    Some(format!("`{text}` is not an element: {hint}"))
}

/// Advice for an element without braces: it may have been written before.
fn without_parameters(element: &Element, model: &Model) -> String {
    let label = element.label.to_string();
    if model.elements().any(|other| other.parameters.is_some() && other.label.to_string() == label) {
        format!(
            "`{element}` is written a second time: an element is written once; let paths meet in a connection, `conn`"
        )
    } else {
        format!("`{element}` lacks its parameters in braces, `{element} {{ name: value, .. }}`")
    }
}

/// The keywords of a table, for a message.
fn list(table: &[(&str, &str)]) -> String {
    table.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

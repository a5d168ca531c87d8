//! Rules that need no graph: keywords, labels, and the parts of an element.

use super::{fields, listed, parameters};
use crate::ast::{Element, Kind, Label, Model, Node};
use crate::diagnostics::Errors;
use crate::keywords::{CONNECTION, ELEMENTS, SUPPORTS, apart, element_of, nearest, support_of};
use crate::topology::Vertex;
use syn::{Ident, Lit};

/// Checks each node and each field by itself.
pub(crate) fn words(model: &Model, errors: &mut Errors) {
    fields::fields(&model.parameters, errors);
    for node in model.nodes() {
        match node {
            Node::Support(keyword) => check_support(keyword, errors),
            Node::Connection(connection) => check_label(&connection.label, errors),
            Node::Element(element) => {
                check_label(&element.label, errors);
                check_element(element, model, errors);
            }
        }
    }
    if model.is_whole && model.elements().next().is_none() {
        let message = "this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`";
        errors.push(model.parameters.ident.span(), message);
    }
}

/// Whether the meaning of a vertex is unknown, so that its arrows are not checked.
pub(crate) fn is_doubtful(vertex: &Vertex<'_>) -> bool {
    match vertex {
        Vertex::Support(keyword) => support_of(&keyword.to_string()).is_none(),
        Vertex::Connection(connection) => !is_well_formed(&connection.label),
        Vertex::Element(element) => !(is_well_formed(&element.label) && is_known(&element.kind)),
    }
}

/// Whether the language or rustc knows the kind: rustc knows types of the user.
fn is_known(kind: &Kind) -> bool {
    matches!(kind, Kind::Type(_)) || kind.known().is_some()
}

/// A label is a name, or a decimal number without leading zero or suffix.
fn is_well_formed(label: &Label) -> bool {
    let Label::Literal(literal) = label else { return true };
    let text = label.to_string();
    let is_plain = text.bytes().all(|b| b.is_ascii_digit()) && (text == "0" || !text.starts_with('0'));
    is_plain && matches!(literal, Lit::Int(_))
}

/// A word that stands alone is a support.
fn check_support(keyword: &Ident, errors: &mut Errors) {
    let text = keyword.to_string();
    if support_of(&text).is_some() {
        return;
    }
    if element_of(&text).is_some() {
        errors.push(keyword.span(), format!("`{text}` needs a label and parameters, `{text} 1 {{ .. }}`"));
        return;
    }
    let supports = || SUPPORTS.iter().map(|(name, _)| *name);
    let hint = match (apart(&text), nearest(supports(), &text)) {
        (Some(apart), _) => format!("put a space before the label, `{apart}`"),
        (None, Some(name)) => format!("did you mean `{name}`?"),
        (None, None) => format!("the supports are {}", listed(supports())),
    };
    errors.push(keyword.span(), format!("`{text}` is not a support: {hint}"));
}

fn check_label(label: &Label, errors: &mut Errors) {
    if !is_well_formed(label) {
        let advice = "a label is a name or a decimal number without leading zero or suffix, such as `arm` or `12`";
        errors.push(label.span(), format!("`{label}` is not a label: {advice}"));
    }
}

/// An element has a known keyword and its parameters.
fn check_element(element: &Element, model: &Model, errors: &mut Errors) {
    if !is_known(&element.kind) {
        errors.push(element.kind.place(), unknown_keyword(&element.kind.name().to_string()));
    } else if element.parameters.is_none() {
        errors.push(element.place(), without_parameters(element, model));
    } else {
        parameters::parameters(element, errors);
    }
}

/// The message for an unknown keyword of an element.
fn unknown_keyword(text: &str) -> String {
    if support_of(text).is_some() {
        return format!("the support `{text}` takes no label and no parameters: write `{text}` alone");
    }
    if text.starts_with(char::is_uppercase) {
        return format!("`{text}` is not an element: a type of your own is written with its path, `self::{text}`");
    }
    let elements = || ELEMENTS.iter().map(|element| element.name);
    let hint = match nearest(elements().chain([CONNECTION]), text) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the elements are {}, or a type of your own by a path with `::`", listed(elements())),
    };
    format!("`{text}` is not an element: {hint}")
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

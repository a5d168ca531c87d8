//! Rules that need no graph: keywords, labels, and the parts of an element.

use super::new_words::in_new_words;
use super::{fields, listed, parameters, selves, spin};
use crate::ast::{Element, Kind, Label, Model, Node, Support};
use crate::diagnostics::Errors;
use crate::keywords::{
    ALONG, CONNECTION, HELD, Keyword, SUPPORTS, absent_element, apart, element_of, elements_of_paths, is_element,
    located_of, meant_element, meant_support, nearest, old_word, support_of,
};
use crate::topology::Vertex;
use syn::Ident;

/// Advice for a word that only models with locations have.
const NEEDS_PLACES: &str = "stands in models whose points have places: say where they are, `conn a at (x, y)`";

/// Checks each field and each node by itself. What a node of a model with locations may be depends on their dimension.
pub(crate) fn words(model: &Model, errors: &mut Errors) {
    fields::fields(&model.parameters, errors);
    selves::selves(model, errors);
    let is_tree = !model.is_located();
    for node in model.nodes() {
        match node {
            Node::Support(support) if is_tree => check_tree_support(support, errors),
            Node::Support(_) => {}
            Node::Connection(connection) => check_label(&connection.label, errors),
            Node::Element(element) => {
                check_label(&element.label, errors);
                if is_tree {
                    check_element(element, model, errors);
                }
            }
        }
    }
    for direction in model.coordinates().filter(|coordinates| is_tree && coordinates.keyword == ALONG) {
        errors.push(direction.keyword.span(), format!("`along` {NEEDS_PLACES}"));
    }
    if model.is_whole && model.elements().next().is_none() {
        let message = "this model has no element: write a path such as `fixed -> beam 1 { .. } -> free;`";
        errors.push(model.parameters.ident.span(), message);
    }
}

/// A support without a place holds freedoms by its keyword alone.
fn check_tree_support(support: &Support, errors: &mut Errors) {
    if support.held.is_some() {
        errors.push(support.keyword.span(), format!("`{HELD}` {NEEDS_PLACES}"));
    } else {
        check_support(&support.keyword, &support_names(), errors);
    }
}

/// The keywords of supports.
pub(super) fn support_names() -> Vec<&'static str> {
    SUPPORTS.iter().map(|(name, _)| *name).collect()
}

/// Whether the meaning of a vertex is unknown, so that its arrows are not checked.
pub(crate) fn is_doubtful(vertex: &Vertex<'_>) -> bool {
    match vertex {
        Vertex::Support(keyword) => support_of(&keyword.to_string()).is_none(),
        Vertex::Connection(connection) => !connection.label.is_well_formed(),
        Vertex::Element(element) => !(element.label.is_well_formed() && is_known(element)),
    }
}

/// Whether the language or rustc knows the kind in a model without places: rustc knows types of the user.
fn is_known(element: &Element) -> bool {
    match &element.kind {
        Kind::Keyword(keyword) => elements_of_paths().any(|row| keyword == row.name),
        Kind::Type(_) => true,
    }
}

/// A word that stands alone is a support.
pub(super) fn check_support(keyword: &Ident, supports: &[&str], errors: &mut Errors) {
    let text = keyword.to_string();
    if supports.contains(&text.as_str()) {
        return;
    }
    if is_element(&text) {
        errors.push(keyword.span(), format!("`{text}` needs a label and parameters, `{text} 1 {{ .. }}`"));
        return;
    }
    let meant = meant_support(&text).or_else(|| nearest(supports.iter().copied(), &text));
    let hint = match (apart(&text), meant) {
        (Some(apart), _) => format!("put a space before the label, `{apart}`"),
        (None, Some(name)) => format!("did you mean `{name}`?"),
        (None, None) => format!("the supports are {}", listed(supports.iter().copied())),
    };
    errors.push(keyword.span(), format!("`{text}` is not a support: {hint}"));
}

fn check_label(label: &Label, errors: &mut Errors) {
    if !label.is_well_formed() {
        let advice = "a label is a name or a decimal number without leading zero or suffix, such as `arm` or `12`";
        errors.push(label.span(), format!("`{label}` is not a label: {advice}"));
    }
}

/// An element has a known keyword and its parameters.
fn check_element(element: &Element, model: &Model, errors: &mut Errors) {
    if !is_known(element) {
        let text = element.kind.name().to_string();
        let message = match (located_of(&text), old_word(&text)) {
            (Some(row), _) if row.is_of_space() => format!("`{text}` {NEEDS_PLACES}").replace("(x, y)", "(x, y, z)"),
            (Some(_), _) => format!("`{text}` {NEEDS_PLACES}"),
            (None, Some(word)) => {
                let row = element_of(word.new, element.dimension);
                in_new_words(element, word, &row.map(Keyword::parameters).unwrap_or_default())
            }
            (None, None) => unknown_keyword(&text, &of_paths()),
        };
        errors.push(element.kind.place(), message);
    } else if element.parameters.is_none() {
        errors.push(element.place(), without_parameters(element, model));
    } else {
        let known = element.known().map(Keyword::parameters);
        parameters::parameters(element, known.as_ref(), errors);
        parameters::one_of_them(element, errors);
        spin::of_beam(element, errors);
        if parameters::names_nothing(element) {
            let advice = "write `stiffness_rz: 0.0`, which lets the rotation go, or another stiffness";
            errors.push(
                element.place(),
                format!("`{element}` names no freedom that gives way, so it would be rigid: {advice}"),
            );
        }
    }
}

/// The keywords of models without places, each once.
fn of_paths() -> Vec<&'static str> {
    let mut names: Vec<&str> = elements_of_paths().map(|element| element.name).collect();
    names.dedup();
    names
}

/// The message for an unknown keyword of an element.
pub(super) fn unknown_keyword(text: &str, elements: &[&str]) -> String {
    if support_of(text).is_some() {
        return format!("the support `{text}` takes no label and no parameters: write `{text}` alone");
    }
    if text.starts_with(char::is_uppercase) {
        return format!("`{text}` is not an element: a type of your own is written with its path, `self::{text}`");
    }
    if let Some(advice) = absent_element(text) {
        return format!("`{text}` is not an element: {advice}");
    }
    let meant = meant_element(text, elements);
    let elements = || elements.iter().copied();
    // `spatial_beam` is a beam of some kind
    let kind = || elements().find(|name| text.strip_suffix(name).is_some_and(|rest| rest.ends_with('_')));
    let hint = match meant.or_else(|| nearest(elements().chain([CONNECTION]), text)).or_else(kind) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("the elements are {}, or a type of your own by a path with `::`", listed(elements())),
    };
    format!("`{text}` is not an element: {hint}")
}

/// Advice for an element without braces: it may have been written before.
pub(super) fn without_parameters(element: &Element, model: &Model) -> String {
    let label = element.label.to_string();
    if model.elements().any(|other| other.parameters.is_some() && other.label.to_string() == label) {
        format!(
            "`{element}` is written a second time: an element is written once; let paths meet in a connection, `conn`"
        )
    } else {
        format!("`{element}` lacks its parameters in braces, `{element} {{ name: value, .. }}`")
    }
}

//! Rules of models with locations that need no graph: keywords, parameters, and what a support holds.

use super::super::new_words::in_new_words;
use super::super::words::{check_support, support_names, unknown_keyword, without_parameters};
use super::super::{listed, parameters};
use super::dimension;
use crate::ast::{Coordinates, Element, Kind, Model, Node, Parameter, Support, place_of, tuple_parts};
use crate::diagnostics::Errors;
use crate::keywords::{
    ALONG, Dimension, FREEDOMS, HELD, LOCATED, LocatedKeyword, RIGID_LINK, Role, STRING, freedom_of, located_of,
    old_word,
};
use std::collections::BTreeSet;
use syn::ext::IdentExt;

/// Checks each node of a model with locations by itself.
pub(crate) fn located_words(model: &Model, dimension: Dimension, errors: &mut Errors) {
    for node in model.nodes() {
        match node {
            Node::Connection(_) => {}
            Node::Support(support) => check_located_support(support, dimension, errors),
            Node::Element(element) => check_located_element(element, model, dimension, errors),
        }
    }
    for direction in model.arrows().filter_map(|arrow| arrow.along.as_ref()) {
        check_direction(direction, dimension, errors);
    }
    check_bodies(model, dimension, errors);
}

/// Directions need a plane to lie in.
fn check_direction(direction: &Coordinates, dimension: Dimension, errors: &mut Errors) {
    match dimension {
        Dimension::Plane => dimension::direction(direction, errors),
        Dimension::Line => {
            let message =
                "`along` needs two coordinates: where points have one, paths act across the line, so remove it";
            errors.push(direction.keyword.span(), message);
        }
    }
}

fn check_located_support(support: &Support, dimension: Dimension, errors: &mut Errors) {
    let keyword = &support.keyword;
    if let Some(held) = &support.held {
        check_held(support, held, dimension, errors);
    } else {
        let mut known = support_names();
        known.push(HELD);
        check_support(keyword, &known, errors);
    }
    if dimension == Dimension::Line && keyword == "roller" {
        let message = "`roller` holds nothing along a line that `pinned` does not: write `pinned`";
        errors.push(keyword.span(), message);
    }
    let Some(direction) = &support.direction else { return };
    match keyword.to_string().as_str() {
        "roller" | "guided" => check_direction(direction, dimension, errors),
        HELD => errors.push(
            direction.keyword.span(),
            "`held` takes no `along`, since its freedoms are those of the axes: a skew support is `roller along (dx, dy)`",
        ),
        text => errors.push(
            direction.keyword.span(),
            format!("`{text}` is alike in all directions: remove `along`, which `roller` and `guided` take"),
        ),
    }
}

/// The freedoms of `held(..)` exist and are different.
fn check_held(support: &Support, held: &[syn::Ident], dimension: Dimension, errors: &mut Errors) {
    let exists = |name: &str| freedom_of(name).is_some_and(|freedom| dimension.freedoms().contains(freedom));
    let mut known = BTreeSet::new();
    for freedom in held {
        let name = freedom.unraw().to_string();
        if !exists(&name) {
            let names = listed(FREEDOMS.iter().map(|(name, _)| *name).filter(|name| exists(name)));
            errors.push(freedom.span(), format!("`{name}` is no freedom of this model: a point has {names}"));
        } else if !known.insert(name.clone()) {
            errors.push(freedom.span(), format!("`{name}` is held already: remove one of the two"));
        }
    }
    if held.is_empty() {
        errors.push(support.keyword.span(), "`held()` holds nothing: name its freedoms, or write `free`");
    }
}

/// An element has a keyword that this dimension knows, its parameters, and no place.
fn check_located_element(element: &Element, model: &Model, dimension: Dimension, errors: &mut Errors) {
    if let Some(location) = &element.location {
        let message = format!(
            "`{element}` has no place of its own: points have places, so write `at` behind the connections around it"
        );
        errors.push(location.keyword.span(), message);
    }
    let text = element.kind.name().to_string();
    if matches!(element.kind, Kind::Type(_)) {
        return match element.parameters {
            Some(_) => parameters::parameters(element, None, errors),
            None => errors.push(element.place(), without_parameters(element, model)),
        };
    }
    let old = old_word(&text).and_then(|word| Some((word, located_of(word.new)?)));
    if let Some((word, new)) = old.filter(|(_, new)| new.instead(dimension).is_none()) {
        let message = in_new_words(element, word, &new.parameters(dimension));
        return errors.push(element.kind.place(), message);
    }
    // what was a body of paths is what bodies of paths are
    let Some(row) = element.located().or(old.map(|(_, new)| new)) else {
        // a string has two rows
        let is_listed =
            |row: &&LocatedKeyword| row.instead(dimension).is_none() && !(row.name == STRING && row.spans_places());
        let known: Vec<&str> = LOCATED.iter().filter(is_listed).map(|row| row.name).collect();
        let message = unknown_keyword(&text, &known);
        return errors.push(element.kind.place(), message);
    };
    if let Some(instead) = row.instead(dimension) {
        // the old word of the plane had its inertia about its input end
        let inertia = if old.is_some() { ", whose `inertia` is about its mass centre" } else { "" };
        let message = format!("`{text}` {}: take `{instead}`{inertia}", reason(row, dimension));
        return errors.push(element.kind.place(), message);
    }
    let [required, optional] = row.parameters(dimension);
    if element.parameters.is_some() {
        check_parameters(element, row, dimension, errors);
    } else if row.role == Role::RigidBody {
        // it may have them at another mention
    } else if required.is_empty() && optional.is_empty() {
        errors.push(element.place(), format!("`{element}` lacks its braces, `{element} {{}}`"));
    } else {
        errors.push(element.place(), without_parameters(element, model));
    }
}

/// Why a keyword has no place in a model.
fn reason(row: &LocatedKeyword, dimension: Dimension) -> &'static str {
    match row.role {
        Role::Unknown => "has its points by offsets, which places replace",
        _ if dimension == Dimension::Plane => "does not stretch, so it stands where points have one coordinate",
        _ => "moves in the plane, but points have one coordinate here",
    }
}

fn check_parameters(element: &Element, row: &LocatedKeyword, dimension: Dimension, errors: &mut Errors) {
    let is_length = |parameter: &&Parameter| row.role == Role::Member && parameter.name.unraw() == "length";
    match element.parameters().find(is_length) {
        Some(length) => {
            let message =
                format!("`{element}` takes no `length`, which follows from the places of its ends: remove it");
            errors.push(length.name.span(), message);
        }
        None => parameters::parameters(element, Some(&row.parameters(dimension)), errors),
    }
    if parameters::names_nothing(element) {
        let advice = format!("write `pin {} {{}}`, which lets the rotation go, or name a stiffness", element.label);
        errors.push(
            element.place(),
            format!("`{element}` names no freedom that gives way, so it would be rigid: {advice}"),
        );
    }
    let vectors =
        element.parameters().filter(|parameter| row.vector.is_some_and(|name| parameter.name.unraw() == name));
    for parameter in vectors {
        check_vector(parameter, dimension, errors);
    }
}

/// The parts of a parameter are as many as those of a place.
fn check_vector(parameter: &Parameter, dimension: Dimension, errors: &mut Errors) {
    let value = parameter.expression();
    let name = &parameter.name;
    let message = match (dimension, tuple_parts(&value)) {
        (Dimension::Plane, Some(parts)) if parts.len() == 2 => return,
        (Dimension::Line, None) => return,
        (Dimension::Plane, _) => {
            let parts = if name == ALONG { "(dx, dy)" } else { "(x, y)" };
            format!("`{name}` has two parts in the plane, which are written as a tuple, `{name}: {parts}`")
        }
        (Dimension::Line, Some(_)) => format!("`{name}` is one number where points have one coordinate: `{name}: x`"),
    };
    errors.push(place_of(&value), message);
}

/// A rigid body has its parameters at one of its mentions.
fn check_bodies(model: &Model, dimension: Dimension, errors: &mut Errors) {
    let is_body = |element: &&Element| element.located().is_some_and(|row| row.role == Role::RigidBody);
    let mut defined = BTreeSet::new();
    for body in model.elements().filter(is_body).filter(|body| body.parameters.is_some()) {
        if !defined.insert(body.label.to_string()) {
            let message = format!("`{body}` has its parameters already: name it again without braces, `{body}`");
            errors.push(body.place(), message);
        }
    }
    let mut missed = BTreeSet::new();
    for body in model.elements().filter(is_body).filter(|body| body.parameters.is_none()) {
        let label = body.label.to_string();
        if !defined.contains(&label) && missed.insert(label) {
            let centre = if dimension == Dimension::Line { "x" } else { "(x, y)" };
            let message = match body.kind.name() {
                name if name == RIGID_LINK => {
                    format!("`{body}` lacks its braces, at one of its mentions: `{body} {{}}`")
                }
                _ => format!(
                    "`{body}` lacks its parameters, at one of its mentions: `{body} {{ mass, inertia, centre: {centre} }}`"
                ),
            };
            errors.push(body.place(), message);
        }
    }
}

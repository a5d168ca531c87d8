//! Rules of models with locations that need no graph: keywords, parameters, and what a support holds.

use super::super::new_words::in_new_words;
use super::super::words::{check_support, support_names, unknown_keyword, without_parameters};
use super::super::{listed, parameters};
use super::{dimension, in_space};
use crate::ast::{Coordinates, Element, Kind, Model, Node, Parameter, Support, place_of, tuple_parts};
use crate::diagnostics::Errors;
use crate::keywords::{
    ABOUT, DISC, Dimension, FREEDOMS, HELD, LOCATED, LocatedKeyword, RIGID_LINK, Role, STRING, Tuple, freedom_of,
    located_of, old_word,
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

/// Directions need a plane to lie in, and axes of rotation space.
fn check_direction(direction: &Coordinates, dimension: Dimension, errors: &mut Errors) {
    let word = &direction.keyword;
    match dimension {
        Dimension::Line | Dimension::Plane if word == ABOUT => {
            let message = "`about` needs three coordinates: a path that turns does so about z here, so remove it";
            errors.push(word.span(), message);
        }
        Dimension::Plane | Dimension::Space => dimension::direction(direction, dimension, errors),
        Dimension::Line => {
            let message = format!(
                "`{word}` needs two coordinates: where points have one, paths act across the line, so remove it"
            );
            errors.push(word.span(), message);
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
    let text = keyword.to_string();
    let is_skew = matches!(text.as_str(), "roller" | "guided");
    let Some(direction) = &support.direction else {
        if is_skew && dimension == Dimension::Space {
            let message = format!(
                "say which way: `{text} normal (0.0, 0.0, 1.0)` holds one direction, `{text} along (1.0, 0.0, 0.0)` leaves one"
            );
            errors.push(keyword.span(), message);
        }
        return;
    };
    let word = &direction.keyword;
    let message = match text.as_str() {
        _ if word == ABOUT => {
            "`about` is the axis of a path that turns: a support has `along` or `normal`, or names what it holds, `held(x, rz)`"
                .to_owned()
        }
        _ if is_skew => return check_direction(direction, dimension, errors),
        HELD => format!(
            "`held` takes no `{word}`, since its freedoms are those of the axes: a skew support is `roller {word} {}`",
            dimension.direction()
        ),
        _ => format!("`{text}` is alike in all directions: remove `{word}`, which `roller` and `guided` take"),
    };
    errors.push(word.span(), message);
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
        Role::Unknown if row.name == DISC => "spins, which nothing with places does",
        Role::Unknown => "has its points by offsets, which places replace",
        Role::Joint if dimension == Dimension::Space => "is a joint of the plane",
        Role::Joint if row.is_of_space() => "is a joint of space",
        _ if row.name == "tapered_beam" && dimension == Dimension::Space => "bends in one plane",
        _ if dimension != Dimension::Line => "does not stretch, so it stands where points have one coordinate",
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
        None => {
            let known = in_space::known(element, row.parameters(dimension));
            parameters::parameters(element, Some(&known), errors);
            in_space::named_twice(element, errors);
        }
    }
    if parameters::names_nothing(element) {
        let (joint, what) =
            if dimension == Dimension::Space { ("ball_joint", "rotations") } else { ("pin", "the rotation") };
        let advice = format!("write `{joint} {} {{}}`, which lets {what} go, or name a stiffness", element.label);
        errors.push(
            element.place(),
            format!("`{element}` names no freedom that gives way, so it would be rigid: {advice}"),
        );
    }
    let all = row.parameters(dimension).concat();
    let is_known = |parameter: &Parameter| all.iter().any(|name| parameter.name.unraw() == name);
    for parameter in element.parameters().filter(|parameter| !parameter.is_told && is_known(parameter)) {
        if let Some(tuple) = row.tuple(&parameter.name.unraw().to_string()) {
            check_tuple(parameter, tuple, dimension, errors);
        }
    }
}

/// The parts of a parameter are as many as those of a place, or as those of a tensor.
fn check_tuple(parameter: &Parameter, tuple: Tuple, dimension: Dimension, errors: &mut Errors) {
    let value = parameter.expression();
    let name = &parameter.name;
    let count = tuple_parts(&value).map(|parts| parts.len());
    let message = match (dimension, tuple) {
        (Dimension::Space, Tuple::Tensor) if matches!(count, Some(3 | 6)) => return,
        (Dimension::Space, Tuple::Tensor) => {
            format!("`{name}` is a tensor in space: `{name}: (xx, yy, zz)`, or with `xy, yz, zx`")
        }
        (Dimension::Line | Dimension::Plane, Tuple::Tensor) | (Dimension::Line, _) if count.is_none() => return,
        (_, Tuple::Tensor) => format!("`{name}` is one moment of inertia in the plane, about z: `{name}: j`"),
        (Dimension::Line, _) => format!("`{name}` is one number where points have one coordinate: `{name}: x`"),
        (Dimension::Plane | Dimension::Space, _) if count == Some(dimension.coordinates()) => return,
        (_, tuple) => {
            let (number, of) =
                if dimension == Dimension::Space { ("three", "in space") } else { ("two", "in the plane") };
            let parts = match tuple {
                Tuple::Place => dimension.example().trim_start_matches("at "),
                _ => dimension.direction(),
            };
            format!("`{name}` has {number} parts {of}, which are written as a tuple, `{name}: {parts}`")
        }
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
            let centre = dimension.example().trim_start_matches("at ");
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

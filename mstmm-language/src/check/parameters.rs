//! The parameters of an element: each must be given once, and no others.

use super::listed;
use super::new_words::value_of;
use crate::ast::{Element, Parameter};
use crate::diagnostics::Errors;
use crate::keywords::{
    AXIAL_STIFFNESS, BAR, CROSS, DAMPING, Dimension, Meant, PAIRS, SPEED, SPIN, STRING, has_somewhere, in_space,
    meant_parameter, nearest, renamed_in,
};
use std::collections::BTreeSet;
use syn::ext::IdentExt;

/// Checks the parameters of one element against those that it must have, and those that it may have. For a type of the user it only checks
/// that each is given once, since rustc knows which.
pub(super) fn parameters(element: &Element, known: Option<&[Vec<&'static str>; 2]>, errors: &mut Errors) {
    let mut given = BTreeSet::new();
    for parameter in element.parameters() {
        if !given.insert(parameter.name.unraw().to_string()) {
            errors.push(
                parameter.name.span(),
                format!("`{element}` gives `{}` a second time: remove one of the two", parameter.name),
            );
        }
    }
    let Some([required, optional]) = known else { return };
    let mut missing: Vec<&str> = required.iter().copied().filter(|name| !given.contains(*name)).collect();
    let is_unknown = |name: &str| !required.contains(&name) && !optional.contains(&name);
    let is_only_one = given.iter().filter(|name| is_unknown(name)).count() == 1 && missing.len() == 1;
    for parameter in element.parameters() {
        let name = parameter.name.unraw().to_string();
        if !is_unknown(&name) || parameter.is_told {
            continue;
        }
        let hint = instead_of(parameter, element, [required, optional], (&mut missing, is_only_one));
        let owner = match parameter.section {
            Some(_) => element.to_string(),
            None => element.kind.name().to_string(),
        };
        errors.push(parameter.name.span(), format!("`{owner}` has no parameter `{name}`: {hint}"));
    }
    // what a section that is not there may have is not missed
    if !missing.is_empty() && element.spread.is_empty() {
        let reason = why_missing(element, &missing);
        errors.push(element.place(), format!("`{element}` lacks {}{reason}", listed(missing)));
    }
}

/// Advice for a parameter that an element does not have. A missing parameter that it names is missing no more.
fn instead_of(
    parameter: &Parameter,
    element: &Element,
    [required, optional]: [&[&'static str]; 2],
    (missing, is_only_one): (&mut Vec<&'static str>, bool),
) -> String {
    let (keyword, name) = (element.kind.name().to_string(), parameter.name.unraw().to_string());
    let renamed = renamed_in(&keyword, &name, &value_of(parameter));
    if DAMPING.contains(&name.as_str()) {
        return advice_on_damping(optional);
    }
    if keyword == STRING && name == AXIAL_STIFFNESS && element.gives("length") {
        return ALONG_ITS_PATH.to_owned();
    }
    if keyword == BAR && TORSION.contains(&name.as_str()) {
        return "both ends of a bar turn freely, so nothing twists it: remove it, or take `beam`".to_owned();
    }
    if keyword == "spring" && matches!(name.as_str(), "stiffness_y" | "stiffness_z") {
        return "it is alike in all directions across a shaft: write `stiffness`".to_owned();
    }
    if CROSS.contains(&name.as_str()) && keyword == "spring" {
        return "it is that of a seal beside a rotor, in a line of paths without places".to_owned();
    }
    if name == SPEED || name == SPIN[0] && (element.dimension == Dimension::Line || element.gives(SPEED)) {
        let taper = if keyword == "tapered_beam" { ": that of a blade about its hub is `rotation_speed`" } else { "" };
        return format!("a `beam` and a `disc` spin, in a line of paths without places{taper}");
    }
    // of a length between places a message of its own speaks
    if let Some(other) = elsewhere(element, &name) {
        return format!("it has that {other} alone, so remove it");
    }
    // in space a hinge has six of them
    let is_ambiguous = element.dimension == Dimension::Space && name == "stiffness";
    if !renamed.is_empty() && !is_ambiguous {
        return format!("write `{}`", renamed.join("` or `"));
    }
    let all: Vec<&'static str> = required.iter().chain(optional).copied().collect();
    if parameter.section.is_none()
        && let Some(meant) = meant_parameter(&name, &all)
    {
        return by_other_name(meant, &all, missing);
    }
    // a string that names a length is a path of one motion
    let is_between_places = element.located().is_some_and(|row| row.name == STRING) && !element.gives("length");
    let length = is_between_places.then_some("length");
    let candidates = || missing.iter().chain(optional).copied().chain(length);
    let meant = candidates().find(|known| known.starts_with(&format!("{name}_")));
    let meant = meant.or_else(|| nearest(candidates(), &name));
    let meant = meant.or(missing.first().copied().filter(|_| is_only_one));
    match meant.filter(|_| parameter.section.is_none()) {
        Some(meant) => {
            missing.retain(|other| *other != meant && !(meant == "length" && *other == AXIAL_STIFFNESS));
            format!("did you mean `{meant}`?")
        }
        None => all_of(&all),
    }
}

/// Advice for a parameter by its name elsewhere.
fn by_other_name(meant: Meant, all: &[&'static str], missing: &mut Vec<&'static str>) -> String {
    match meant {
        Meant::Same(names) => {
            let meant = names.iter().find(|name| all.contains(name)).copied().unwrap_or_default();
            missing.retain(|other| !names.contains(other));
            format!("did you mean `{meant}`?")
        }
        Meant::Factor(products) => {
            let is_meant = |name: &str| products.iter().any(|(product, _)| *product == name);
            let is_plane_meant =
                |name: &str| PAIRS.iter().any(|pair| pair.both == name && pair.planes.into_iter().any(is_meant));
            missing.retain(|name| !is_meant(name) && !is_plane_meant(name));
            let here = products.iter().filter(|(name, _)| all.contains(name));
            let products: Vec<String> = here.map(|(name, product)| format!("`{name}: {product}`")).collect();
            format!("it takes products, {}", products.join(" and "))
        }
    }
}

/// What an element has; of a parameter of both planes the name for both.
fn all_of(all: &[&'static str]) -> String {
    if all.is_empty() {
        return "it has none, so remove it".to_owned();
    }
    let is_of_one_plane = |name: &&str| PAIRS.iter().any(|pair| pair.planes.contains(name) && all.contains(&pair.both));
    let of_one_plane = all.iter().copied().find(is_of_one_plane);
    let list = listed(all.iter().copied().filter(|name| !is_of_one_plane(name)));
    let planes = of_one_plane.map_or_else(String::new, |name| format!("; some for one plane alone, such as `{name}`"));
    format!("it has {list}{planes}")
}

/// Where else an element has a parameter that it has not here.
fn elsewhere(element: &Element, name: &str) -> Option<&'static str> {
    let keyword = element.kind.name().to_string();
    let is_of_one_plane = PAIRS.iter().any(|pair| pair.planes.contains(&name));
    let is_in_space = in_space(&keyword).is_some_and(|row| row.parameters().concat().contains(&name));
    if name == "length" || is_of_one_plane {
        return None;
    }
    if has_somewhere(&keyword, name) && name != SPIN[0] {
        return Some(if element.dimension == Dimension::Line { "in the plane" } else { "along a line" });
    }
    is_in_space.then_some("in space")
}

/// Why an element needs what it lacks, where that is not plain.
fn why_missing(element: &Element, missing: &[&str]) -> &'static str {
    let Some(row) = element.known() else { return "" };
    let is_in_space = element.dimension == Dimension::Space;
    match row.name {
        "beam" if is_in_space => IN_SPACE,
        "rod" if is_in_space && missing == ["length"] => ": between two places take `bar`",
        "shaft" if is_in_space && missing == ["length"] => ": between two places take `beam`",
        BAR if missing.contains(&"bending_stiffness") => BETWEEN_ITS_ENDS,
        STRING if row.stretches() && missing.contains(&AXIAL_STIFFNESS) => BETWEEN_PLACES,
        _ if row.stretches() && missing.contains(&AXIAL_STIFFNESS) => IN_PLANE,
        _ => "",
    }
}

/// Of parameters that say the same in different ways one is named.
pub(super) fn one_of_them(element: &Element, errors: &mut Errors) {
    let Some(row) = element.known().filter(|row| !row.one_of.is_empty()) else { return };
    let is_one = |parameter: &&Parameter| row.one_of.iter().any(|name| parameter.name.unraw() == name);
    let mut named = element.parameters().filter(is_one);
    let Some(first) = named.next() else {
        if element.spread.is_empty() {
            errors.push(
                element.place(),
                format!("`{element}` lacks `inertia`, about its mass centre, or `inertia_about_input`"),
            );
        }
        return;
    };
    for second in named.filter(|second| second.name.unraw() != first.name.unraw()) {
        let message = format!("`{element}` gives its inertia twice: remove `{}` or `{}`", first.name, second.name);
        errors.push(second.name.span(), message);
    }
}

/// Why a string of a path has no axial stiffness.
const ALONG_ITS_PATH: &str = "with `length` it is a path of one motion and does not stretch: remove it, or remove `length` where it stands between two \
                              places of the plane";

/// What a string between two places needs, and what one of a path has instead.
const BETWEEN_PLACES: &str = ": between places a string stretches, too; one of a path of one motion names its `length`";
/// Why a bar has a bending stiffness.
const BETWEEN_ITS_ENDS: &str = ": it has its mass along it, so it bends between its ends";
/// Why a beam needs more in space.
const IN_SPACE: &str = ": a beam in space stretches, turns about its axis and bends both ways; for a bar, `bar`";
/// What a bar has not.
const TORSION: [&str; 2] = ["torsional_stiffness", "polar_inertia_per_length"];
/// Why a beam needs more in the plane.
const IN_PLANE: &str = ": in the plane a beam stretches, too; a large number is one that hardly does";

/// Whether an element names none of the parameters of which it needs one: a hinge in which nothing gives way.
pub(super) fn names_nothing(element: &Element) -> bool {
    let needs_one = element.known().is_some_and(|row| row.required.is_empty() && row.name == "hinge");
    // a misspelt one has a message of its own
    let gives_no_way = |parameter: &Parameter| DAMPING.iter().any(|name| parameter.name.unraw() == name);
    needs_one && element.parameters.is_some() && element.spread.is_empty() && element.parameters().all(gives_no_way)
}

/// Advice for a parameter of damping that an element does not take, given those that it takes.
fn advice_on_damping(taken: &[&str]) -> String {
    let mut taken = taken.iter().copied().filter(|name| DAMPING.contains(name)).peekable();
    if taken.peek().is_none() {
        return "springs, torsion springs, uniform beams, rods and shafts have damping of their own, strings an external one"
            .to_owned();
    }
    format!("of damping it has {}", listed(taken))
}

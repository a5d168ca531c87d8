//! What spins: a rotor's shafts and discs name all that their gyroscopic moments need.

use super::listed;
use crate::ast::{Element, Parameter};
use crate::diagnostics::Errors;
use crate::keywords::{SPEED, SPIN};
use syn::ext::IdentExt;

/// Where a shaft that spins has its parameters.
const OF_SHAFT: [&str; 3] = ["rotary_inertia", SPIN[0], SPIN[1]];

/// A parameter of damping that nothing which spins has.
const LOSS_FACTOR: &str = "loss_factor";

/// Checks a beam along a line that spins: it names its rotary inertia, its polar inertia and its speed, or neither of the last two.
pub(super) fn of_beam(element: &Element, errors: &mut Errors) {
    let named = |name: &str| element.parameters().find(|parameter| parameter.name.unraw() == name);
    let Some(first) = SPIN.iter().find_map(|name| named(name)) else { return };
    if element.known().is_none_or(|row| row.name != "beam" || !row.optional.contains(&SPEED)) {
        return;
    }
    let missing = OF_SHAFT.into_iter().filter(|name| named(name).is_none());
    let missing: Vec<&str> = missing.collect();
    if !missing.is_empty() && element.spread.is_empty() {
        let name = first.name.unraw();
        let advice = "a beam that spins has all three, one that does not has neither a polar inertia nor a speed";
        errors.push(first.name.span(), format!("`{element}` names `{name}` and lacks {}: {advice}", listed(missing)));
    }
    if let Some(Parameter { name, .. }) = named(LOSS_FACTOR) {
        let advice = "the loss of a shaft changes its sign where it whirls at its speed: name `kelvin_voigt_time`, which turns with it";
        errors.push(name.span(), format!("`{element}` has no `{LOSS_FACTOR}` beside `{SPEED}`: {advice}"));
    }
}

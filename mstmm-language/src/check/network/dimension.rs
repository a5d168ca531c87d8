//! The dimension of a model with locations: the number of coordinates of its points.

use crate::ast::{Coordinates, Model, Node};
use crate::diagnostics::Errors;
use crate::keywords::Dimension;
use syn::Expr;

/// Finds the dimension, and reports places and directions that do not fit it.
///
/// The first place decides. Where none has a number of coordinates that there is, which is an error, it is the plane.
pub(crate) fn dimension(model: &Model, errors: &mut Errors) -> Dimension {
    let places: Vec<(String, &Coordinates)> = model.nodes().filter_map(named_place).collect();
    for (_, place) in places.iter().filter(|(_, place)| in_brackets(place).is_some()) {
        errors.push(place.value, "a place is a tuple, in parentheses: `at (x, y)` or `at (x, y, z)`");
    }
    for (_, place) in &places {
        if place.is_tuple && !matches!(place.parts.len(), 2 | 3) {
            errors.push(place.value, wrong_number(place.parts.len()));
        }
    }
    let Some((first, decisive)) = places.iter().find(|(_, place)| has_dimension(place)) else {
        return Dimension::Plane;
    };
    let count = count(decisive);
    let is_other = |place: &Coordinates| has_dimension(place) && self::count(place) != count;
    for (name, place) in places.iter().filter(|(_, place)| is_other(place)) {
        let message = format!(
            "the place of `{name}` has {}, that of `{first}` {}: all points of a model have equally many{}",
            number(self::count(place)),
            counted(count),
            if count > 1 && !place.is_tuple { ", and those of several are tuples where they stand" } else { "" }
        );
        errors.push(place.value, message);
    }
    match count {
        1 => Dimension::Line,
        2 => Dimension::Plane,
        _ => Dimension::Space,
    }
}

/// The place of a point, with the name of the point.
fn named_place(node: &Node) -> Option<(String, &Coordinates)> {
    let name = match node {
        Node::Support(support) => support.keyword.to_string(),
        Node::Connection(connection) => connection.to_string(),
        Node::Element(_) => return None,
    };
    Some((name, node.location()?))
}

fn has_dimension(place: &Coordinates) -> bool {
    !place.is_tuple || matches!(place.parts.len(), 2 | 3)
}

fn wrong_number(count: usize) -> String {
    let cure = "a point has two coordinates, `at (x, y)`, or three, `at (x, y, z)`; one is written without parentheses, `at x`";
    format!("a tuple of {} is no place: {cure}", counted(count))
}

/// `two coordinates`
fn number(count: usize) -> String {
    format!("{} {}", counted(count), if count == 1 { "coordinate" } else { "coordinates" })
}

pub(super) fn counted(count: usize) -> String {
    let words = ["none", "one", "two", "three", "four"];
    words.get(count).map_or_else(|| count.to_string(), |&word| word.to_owned())
}

/// Checks the number of parts of a direction, `along (dx, dy)`.
pub(super) fn direction(direction: &Coordinates, dimension: Dimension, errors: &mut Errors) {
    if !(direction.is_tuple && direction.parts.len() == dimension.coordinates()) {
        let (of, count) = match dimension {
            Dimension::Space => ("in space", "three"),
            Dimension::Line | Dimension::Plane => ("of the plane", "two"),
        };
        let form = dimension.direction();
        let message = format!("a direction {of} has {count} parts, `{} {form}`", direction.keyword);
        errors.push(direction.value, message);
    }
}

/// The number of coordinates of a place in brackets, which is none.
fn in_brackets(place: &Coordinates) -> Option<usize> {
    match place.parts.as_slice() {
        [Expr::Array(array)] => Some(array.elems.len()),
        _ => None,
    }
}

/// The number of coordinates of a place, as it is meant.
fn count(place: &Coordinates) -> usize {
    in_brackets(place).unwrap_or(place.parts.len())
}

//! Whether a model without places moves along a line or in the plane.

use crate::ast::{Element, Kind, Model};
use crate::keywords::{Dimension, elements_of_paths, old_word};
use mstmm_plan::Space;

/// The parameters that elements have in the plane alone. A `rod` has an axial stiffness in a path of one motion.
const OF_THE_PLANE: [&str; 5] = ["axial_stiffness", "output_y", "centre_y", "stiffness_x", "damping_x"];

/// The dimension of a model without places: the plane, if an element names what there is in the plane alone.
pub(crate) fn dimension_of_paths(model: &Model) -> Dimension {
    if model.elements().any(is_planar) { Dimension::Plane } else { Dimension::Line }
}

fn is_planar(element: &Element) -> bool {
    let Kind::Keyword(keyword) = &element.kind else { return false };
    let keyword = keyword.to_string();
    let name = old_word(&keyword).map_or(keyword.as_str(), |word| word.new);
    let mut rows = elements_of_paths().filter(|row| row.name == name);
    let spaces = (rows.next().map(|row| row.space), rows.next().map(|row| row.space));
    match spaces {
        // a word that is one thing along a line and another one in the plane
        (Some(_), Some(_)) => OF_THE_PLANE.iter().any(|name| element.gives(name)),
        (space, _) => space == Some(Space::Planar),
    }
}

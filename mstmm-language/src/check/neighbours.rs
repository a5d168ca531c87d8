//! Elements that an arrow joins, and that cannot be meant: a mass on a beam is another element than one on a spring.

use crate::ast::Element;
use crate::diagnostics::Errors;
use crate::topology::{Graph, Vertex};
use mstmm_plan::Space;

/// Refuses a mass or an inertia of a path of one motion beside a bending element.
pub(super) fn masses_on_beams(graph: &Graph<'_>, errors: &mut Errors) {
    for edge in &graph.edges {
        let (Vertex::Element(one), Vertex::Element(other)) = (&graph.vertices[edge.from], &graph.vertices[edge.to])
        else {
            continue;
        };
        let (mass, beam) = if is_mass(one) { (one, other) } else { (other, one) };
        if is_mass(mass) && space_of(beam) == Some(Space::Bending) {
            let message = format!(
                "`{beam}` bends, and `{mass}` stands in a path of one motion: write `point_mass {} {{ mass, inertia }}`",
                mass.label
            );
            errors.push(mass.place(), message);
        }
    }
}

fn is_mass(element: &Element) -> bool {
    let name = element.kind.name();
    element.kind.known().is_some() && (name == "mass" || name == "inertia")
}

fn space_of(element: &Element) -> Option<Space> {
    element.kind.known().map(|known| known.space)
}

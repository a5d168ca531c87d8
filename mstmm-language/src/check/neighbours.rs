//! Elements that an arrow joins, and that cannot be meant: a mass on a beam is another element than one on a spring.

use crate::ast::Element;
use crate::diagnostics::Errors;
use crate::topology::{Graph, Vertex};
use mstmm_plan::Space;

/// Refuses a mass or an inertia beside a bending element, unless a path of its own motion goes on behind it.
pub(super) fn masses_on_beams(graph: &Graph<'_>, errors: &mut Errors) {
    for (index, vertex) in graph.vertices.iter().enumerate() {
        let Vertex::Element(mass) = vertex else { continue };
        let Some(own) = space_of_mass(mass) else { continue };
        let beside: Vec<&Element> = neighbours(graph, index).collect();
        let is_in_a_path = beside.iter().any(|other| space_of(other) == Some(own));
        let Some(beam) = beside.iter().find(|other| space_of(other) == Some(Space::Bending)) else { continue };
        if !is_in_a_path {
            let message = format!(
                "`{beam}` bends, and `{mass}` stands in a path of one motion: write `point_mass {} {{ mass, inertia }}`",
                mass.label
            );
            errors.push(mass.place(), message);
        }
    }
}

/// The elements at both sides of one.
fn neighbours<'g>(graph: &'g Graph<'_>, index: usize) -> impl Iterator<Item = &'g Element> {
    let others = graph.edges.iter().filter_map(move |edge| match index {
        _ if edge.to == index => Some(edge.from),
        _ if edge.from == index => Some(edge.to),
        _ => None,
    });
    others.filter_map(|other| match &graph.vertices[other] {
        Vertex::Element(element) => Some(&**element),
        Vertex::Support(_) | Vertex::Connection(_) => None,
    })
}

/// The space of a mass or an inertia of the language.
fn space_of_mass(element: &Element) -> Option<Space> {
    let name = element.kind.name();
    if name == "mass" || name == "inertia" { space_of(element) } else { None }
}

fn space_of(element: &Element) -> Option<Space> {
    element.known().map(|known| known.space)
}

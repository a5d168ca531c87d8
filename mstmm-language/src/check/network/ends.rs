//! Rules of the arrows at one node: how many there are, and which way they point.

use super::super::tree::{element_fault, support_fault};
use crate::diagnostics::{Errors, Place};
use crate::keywords::Role;
use crate::network::{Edge, Graph};

const TURN: &str = "but one end of an element is its input and the other its output: turn one of the arrows round";

/// Checks the arrows at each node whose meaning is known.
pub(super) fn ends(graph: &Graph<'_>, errors: &mut Errors) {
    for (index, vertex) in graph.vertices.iter().enumerate() {
        let places = |is_end: fn(&Edge<'_>, usize) -> bool| -> Vec<Place> {
            graph.edges.iter().filter(|edge| is_end(edge, index)).map(|edge| edge.arrow.place).collect()
        };
        let (inputs, outputs) = (places(|edge, vertex| edge.to == vertex), places(|edge, vertex| edge.from == vertex));
        let arrows = inputs.len() + outputs.len();
        let here = vertex.place();
        let fault = match vertex.role {
            Role::Support => support_fault(arrows).map(|fault| (here, fault.to_owned())),
            Role::Connection => connection_fault(graph, index, arrows).map(|(place, fault)| (place, fault.to_owned())),
            Role::PointMass | Role::RigidBody if arrows == 0 => {
                Some((here, "is joined to nothing: lead an arrow to it from a connection with a place".to_owned()))
            }
            Role::Member | Role::Joint | Role::Path => extent_fault(here, &inputs, &outputs),
            Role::PointMass | Role::RigidBody | Role::Unknown => None,
        };
        if let Some((place, fault)) = fault {
            errors.push(place, format!("`{}` {fault}", vertex.name()));
        }
    }
}

/// An element between two points has an input and an output.
fn extent_fault(here: Place, inputs: &[Place], outputs: &[Place]) -> Option<(Place, String)> {
    match (inputs, outputs) {
        ([_, .., last], []) => Some((*last, format!("has two inputs, {TURN}"))),
        ([], [_, .., last]) => Some((*last, format!("has two outputs, {TURN}"))),
        _ => element_fault(here, inputs, outputs).map(|(place, fault)| (place, fault.to_owned())),
    }
}

/// A connection joins elements, and not itself.
fn connection_fault(graph: &Graph<'_>, index: usize, arrows: usize) -> Option<(Place, &'static str)> {
    let here = graph.vertices[index].place();
    if arrows == 0 {
        return Some((here, "is joined to nothing: let the path of an element end in it"));
    }
    if let Some((_, edge)) = graph.edges_of(index).find(|(_, edge)| edge.from == edge.to) {
        return Some((edge.arrow.place, "is joined to itself: lead this arrow on to an element"));
    }
    joins_none(graph, index).then_some((here, "joins no element: let the path of an element end in it"))
}

/// Whether arrows lead from a connection to supports and other connections alone, and it is the first of these connections.
fn joins_none(graph: &Graph<'_>, index: usize) -> bool {
    let mut reached = vec![index];
    let mut next = 0;
    while let Some(&connection) = reached.get(next) {
        next += 1;
        for (_, edge) in graph.edges_of(connection) {
            let other = edge.other(connection);
            match graph.role(other) {
                Role::Support => {}
                Role::Connection if other < index => return false,
                Role::Connection if reached.contains(&other) => {}
                Role::Connection => reached.push(other),
                _ => return false,
            }
        }
    }
    true
}

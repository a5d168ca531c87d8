//! Rules of the graph: it is a tree of transfer paths, and every arrow leads to the one root.

use super::is_doubtful;
use super::neighbours::masses_on_beams;
use crate::ast::Model;
use crate::diagnostics::{Errors, Place};
use crate::topology::{Graph, Vertex};

/// A graph whose every arrow leads to the root.
pub(crate) struct Tree<'g, 'a> {
    pub(crate) graph: &'g Graph<'a>,
    pub(crate) root: usize,
}

/// Checks the graph, unless a line of it is missing, and ends with all errors found so far.
pub(crate) fn topology<'g, 'a>(model: &Model, graph: &'g Graph<'a>, mut errors: Errors) -> syn::Result<Tree<'g, 'a>> {
    let mut root = None;
    if model.is_whole && model.elements().next().is_some() {
        root = check_graph(graph, &mut errors);
    }
    errors.propagate()?;
    // where there is no root, that was an error
    Ok(Tree { graph, root: root.unwrap_or(0) })
}

/// Checks the numbers of inputs and outputs of every vertex whose meaning is known, and that the paths of faultless vertices lead to
/// one root.
fn check_graph(graph: &Graph<'_>, errors: &mut Errors) -> Option<usize> {
    let mut is_clear = Vec::new();
    for (index, vertex) in graph.vertices.iter().enumerate() {
        let is_meant = !graph.ambiguous.contains(&index) && !is_doubtful(vertex);
        let fault = if is_meant { ends_fault(graph, index) } else { None };
        is_clear.push(is_meant && fault.is_none());
        if let Some((place, fault)) = fault {
            errors.push(place, format!("`{}` {fault}", vertex.name()));
        }
    }
    masses_on_beams(graph, errors);
    find_root(graph, &is_clear, errors)
}

/// The fault in the number of inputs and outputs of one vertex, if there is one.
fn ends_fault(graph: &Graph<'_>, index: usize) -> Option<(Place, &'static str)> {
    let inputs = graph.edges.iter().filter(|edge| edge.to == index).map(|edge| edge.place).collect::<Vec<_>>();
    let outputs = graph.edges.iter().filter(|edge| edge.from == index).map(|edge| edge.place).collect::<Vec<_>>();
    let place = graph.vertices[index].place();
    match graph.vertices[index] {
        Vertex::Support(_) => support_fault(inputs.len() + outputs.len()).map(|fault| (place, fault)),
        Vertex::Element(_) => element_fault(place, &inputs, &outputs),
        Vertex::Connection(_) => connection_fault(graph, index),
    }
}

/// A support ends a path.
pub(super) fn support_fault(arrows: usize) -> Option<&'static str> {
    match arrows {
        1 => None,
        0 => Some("holds nothing: join it to an element or a connection by an arrow"),
        _ => Some(
            "stands in the middle of a path, but a support ends one: hold a point in between by a connection, \
             `support -> conn ..`",
        ),
    }
}

/// An element stands in one path, so it has an arrow on either side at most: one leads in, the other on.
pub(super) fn element_fault(place: Place, inputs: &[Place], outputs: &[Place]) -> Option<(Place, &'static str)> {
    match (inputs, outputs) {
        ([], []) => Some((place, "is joined to nothing: begin and end its path with a support or a connection")),
        ([], [_]) => Some((place, "has no input: begin its path with a support or a connection")),
        ([_], []) => Some((place, "has no output: end its path with a support or a connection")),
        ([.., last], []) => {
            Some((*last, "has two inputs, but one arrow leads in and the other on to the root: turn one of them round"))
        }
        ([], [.., last]) => Some((
            *last,
            "has two outputs, but every arrow leads to the one root: turn the arrows of one of the two paths round",
        )),
        _ => None,
    }
}

/// A connection has inputs and one output, and joins elements.
fn connection_fault(graph: &Graph<'_>, index: usize) -> Option<(Place, &'static str)> {
    let place = graph.vertices[index].place();
    if let Some(edge) = graph.edges.iter().find(|edge| edge.from == index && edge.to == index) {
        return Some((edge.place, "is joined to itself: lead this arrow on to an element or to the root"));
    }
    let outputs: Vec<usize> = (0..graph.edges.len()).filter(|&edge| graph.edges[edge].from == index).collect();
    match outputs.as_slice() {
        [] => Some((place, "has no output: lead it on to the root")),
        [_] if graph.inputs(index).is_empty() => Some((place, "has no input: let paths end in it")),
        [_] if joins_supports_alone(graph, index) => {
            Some((place, "joins no element: let the path of an element end in it"))
        }
        [_] => None,
        [.., last] => Some(match outputs.iter().rev().find(|&&edge| graph.is_in_a_loop(edge)) {
            Some(edge) => (graph.edges[*edge].place, loop_fault(graph, outputs.as_slice())),
            None => (
                graph.edges[*last].place,
                "has two outputs, but every arrow leads to the one root: turn the arrows of one of the two paths round",
            ),
        }),
    }
}

/// The fault of the outputs of a connection, some of which are parts of a loop.
fn loop_fault(graph: &Graph<'_>, outputs: &[usize]) -> &'static str {
    // what leads from this connection to another one, by an element alone
    let sides = |name: &str| {
        outputs.iter().map(|&edge| graph.edges[edge].to).find_map(|vertex| match &graph.vertices[vertex] {
            Vertex::Element(element) if element.kind.name() == name => graph.output(vertex),
            _ => None,
        })
    };
    let are_beside = |[one, other]: [&str; 2]| sides(one).is_some_and(|end| sides(other) == Some(end));
    if are_beside(["spring", "damper"]) {
        return "leads by a spring and a dashpot to the same connection: write both as one, `spring` with `damping`";
    }
    if are_beside(["torsion_spring", "torsion_damper"]) {
        return "leads by a spring and a dashpot to the same connection: write both as one, `torsion_spring` with `damping`";
    }
    "has two outputs, and this one is part of a closed loop: a model without places is a tree of paths; cut the loop open, or give its \
     connections and supports places, `at (x, y)`"
}

/// Whether a connection has supports around it and nothing else but, perhaps, another connection behind it.
fn joins_supports_alone(graph: &Graph<'_>, index: usize) -> bool {
    let is_support = |vertex: &usize| {
        matches!(graph.vertices[*vertex], Vertex::Support(_)) && !is_doubtful(&graph.vertices[*vertex])
    };
    let leads_to_element =
        graph.output(index).is_some_and(|output| matches!(graph.vertices[output], Vertex::Element(_)));
    graph.inputs(index).iter().all(is_support) && !leads_to_element
}

/// The end of the path from a vertex.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    /// In a support, where every vertex of one sketch ends.
    Root(usize),
    /// In a closed loop, given by its first vertex in the source.
    Loop(usize),
}

/// The support in which the paths of all clear vertices end. Every clear vertex but a root has one output.
fn find_root(graph: &Graph<'_>, is_clear: &[bool], errors: &mut Errors) -> Option<usize> {
    let mut ends: Vec<End> = Vec::new();
    let starts = (0..graph.vertices.len()).filter(|vertex| graph.output(*vertex).is_some());
    for end in starts.filter_map(|start| follow(graph, is_clear, start)) {
        if !ends.contains(&end) {
            ends.push(end);
        }
    }
    let mut root = None;
    for end in ends {
        let (vertex, message) = match (end, root) {
            (End::Root(vertex), None) => {
                root = Some(vertex);
                continue;
            }
            (End::Loop(vertex), _) => (
                vertex,
                "does not lead to the root, but round in a loop of arrows back to itself: turn one of them to a support",
            ),
            (End::Root(vertex), Some(_)) => {
                (vertex, "is a second root: no path joins this part of the model to the first; a model is one tree")
            }
        };
        errors.push(graph.vertices[vertex].place(), format!("`{}` {message}", graph.vertices[vertex].name()));
    }
    root
}

/// Follows the arrows from a vertex; `None` if they lead to one that is not clear.
fn follow(graph: &Graph<'_>, is_clear: &[bool], start: usize) -> Option<End> {
    let mut vertex = start;
    for _ in 0..graph.vertices.len() {
        if !is_clear[vertex] {
            return None;
        }
        match graph.output(vertex) {
            None => return Some(End::Root(vertex)),
            Some(next) => vertex = next,
        }
    }
    // as many steps as there are vertices lead into the loop: go round it once more
    let mut first = vertex;
    let mut next = graph.output(vertex).unwrap_or(vertex);
    while next != vertex {
        first = first.min(next);
        next = graph.output(next).unwrap_or(vertex);
    }
    Some(End::Loop(first))
}

//! The labels of a drawing: points, parts and largest values, each once.

use crate::diagram::Diagram;
use crate::drawing::Drawing;
use crate::figure::{Figure, Part, label_of};
use crate::kind::Kind;
use crate::labels::{SIZE, Subject, Wanted};
use crate::room::Shell;
use crate::symbols::bodies::{BORDER, HALF, hull};
use crate::vector::{Vector, between, distance, plus};

/// How far from the mark of a mass centre a label in the body begins.
const BESIDE_CENTRE: f64 = 7.0;

/// Parts of the way from the mass centre to what a body ties at which its label may stand.
const INSIDE: [f64; 5] = [0.5, 0.4, 0.6, 0.3, 0.7];

/// The labels of points, parts and largest values, each once, and those of loads.
pub(crate) fn wanted<M>(drawing: &Drawing<M>, diagrams: &[Diagram], loads: Vec<Wanted>) -> Vec<Wanted> {
    let figure = &drawing.figure;
    let mut wanted: Vec<Wanted> = Vec::new();
    let mut add = |name: &str, class, subject| {
        if let Some(text) = label_of(name).filter(|_| !name.starts_with("link of") && !name.starts_with("ground of")) {
            let label = Wanted { text: text.to_owned(), class, title: name.to_owned(), subject };
            let is_new = wanted.iter().all(|known| known.title != label.title);
            wanted.extend(Some(label).filter(|_| is_new));
        }
    };
    for anchor in figure.anchors.iter().filter(|_| drawing.is_labelled) {
        add(anchor.name.as_deref().unwrap_or_default(), "point", Subject::Point(anchor.at));
    }
    for part in figure.parts.iter().filter(|part| drawing.is_labelled && part.kind != Kind::Tie) {
        let [from, to] = [part.ends[0], part.ends[part.ends.len() - 1]].map(|end| figure.anchors[end].at);
        let is_joint = part.kind.is_joint() && from == to;
        add(&part.name, if is_joint { "joint" } else { "element" }, subject(figure, part, [from, to]));
    }
    wanted.extend(diagrams.iter().filter_map(|diagram| diagram.label.clone()));
    wanted.extend(loads);
    // what has room inside takes it before others lead lines through it
    wanted.sort_by_key(|label| !matches!(label.subject, Subject::Shell(..)));
    wanted
}

/// What the label of a part names, from its first end to its last.
fn subject<M>(figure: &Figure<M>, part: &Part<M>, [from, to]: [Vector; 2]) -> Subject {
    match part.kind {
        Kind::Body => {
            let ends: Vec<Vector> = part.ends.iter().map(|end| figure.anchors[*end].at).collect();
            let corners = hull(&ends).into_iter().map(|end| ends[end]).collect();
            Subject::Shell(Shell { corners, border: BORDER }, in_body(to, &ends[..ends.len() - 1]))
        }
        Kind::Mass => {
            let corners = [[-HALF, -HALF], [HALF, -HALF], [HALF, HALF], [-HALF, HALF]].map(|way| plus(from, way, 1.0));
            Subject::Shell(Shell { corners: corners.into(), border: 0.0 }, vec![from])
        }
        kind if kind.is_body() => Subject::Point(to),
        _ if distance(from, to) > SIZE => Subject::Line([from, to]),
        _ => Subject::Point(between(from, to, 0.5)),
    }
}

/// Places for a label in a body: beside its mass centre, and between that and what it ties.
fn in_body(centre: Vector, tied: &[Vector]) -> Vec<Vector> {
    let beside = BESIDE_CENTRE + 0.5 * SIZE;
    let around = [[1.0, 0.0], [-1.0, 0.0], [0.0, -1.0], [0.0, 1.0]].map(|way| plus(centre, way, beside));
    let towards = tied.iter().flat_map(|end| INSIDE.map(|part| between(centre, *end, part)));
    around.into_iter().chain(towards).collect()
}

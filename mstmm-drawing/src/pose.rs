//! Where everything is at one moment.

use crate::figure::Figure;
use crate::ink::Ink;
use crate::motion::Motion;
use crate::shape::Number;
use crate::symbols::inks;
use crate::vector::{Vector, between, plus};

/// The places of all anchors, and the lines of all parts.
pub(crate) struct Pose {
    anchors: Vec<Vector>,
    curves: Vec<Vec<Vector>>,
}

impl Pose {
    /// The model at rest.
    pub(crate) fn at_rest<M>(figure: &Figure<M>) -> Self {
        let anchors = figure.anchors.iter().map(|anchor| anchor.at).collect();
        Pose { anchors, curves: vec![Vec::new(); figure.parts.len()] }
    }

    /// The model in a motion, given a number by which displacements are multiplied before their real parts are drawn.
    pub(crate) fn moved<M>(figure: &Figure<M>, motion: &Motion, by: Number) -> Self {
        let moved = |at: Vector, displacement: [Number; 3]| {
            let [x, y] = figure.sight.seen(displacement);
            plus(at, [(x * by).re, -(y * by).re], 1.0)
        };
        let anchors = figure.anchors.iter().zip(&motion.anchors);
        let curves = figure.parts.iter().zip(&motion.curves).map(|(part, curve)| {
            let [from, to] = [part.ends[0], part.ends[1]].map(|end| figure.anchors[end].at);
            curve.iter().map(|(part, displacement)| moved(between(from, to, *part), *displacement)).collect()
        });
        Pose {
            anchors: anchors.map(|(anchor, displacement)| moved(anchor.at, *displacement)).collect(),
            curves: curves.collect(),
        }
    }

    /// What is drawn of a part.
    pub(crate) fn inks<M>(&self, figure: &Figure<M>, part: usize) -> Vec<Ink> {
        let ends = &figure.parts[part].ends;
        let rest: Vec<Vector> = ends.iter().map(|end| figure.anchors[*end].at).collect();
        let now: Vec<Vector> = ends.iter().map(|end| self.anchors[*end]).collect();
        inks(figure.parts[part].kind, &figure.sight, &rest, (&now, &self.curves[part]))
    }
}

//! Where everything is at one moment.

use crate::figure::Figure;
use crate::ink::Ink;
use crate::motion::Motion;
use crate::shape::Number;
use crate::symbols::inks;
use crate::vector::{Vector, between, plus};
use std::f64::consts::TAU;

/// Moments of a motion whose parts are out of phase, between which it is drawn straight.
const MOMENTS: u32 = 16;

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

    /// The model at moments of a period of a motion: at both ends of it and back, or, of one whose parts are out of phase, at more.
    pub(crate) fn moments<M>(figure: &Figure<M>, motion: &Motion, reach: Number) -> Vec<Self> {
        let count = if motion.is_complex { MOMENTS } else { 2 };
        let angles = (0..=count).map(|moment| TAU * f64::from(moment) / f64::from(count));
        angles.map(|angle| Pose::moved(figure, motion, reach * Number::from_polar(1.0, angle))).collect()
    }

    /// The straight line between two anchors.
    pub(crate) fn line(&self, ends: [usize; 2]) -> [Vector; 2] {
        ends.map(|end| self.anchors[end])
    }

    /// What is drawn of a part.
    pub(crate) fn inks<M>(&self, figure: &Figure<M>, part: usize) -> Vec<Ink> {
        let ends = &figure.parts[part].ends;
        let rest: Vec<Vector> = ends.iter().map(|end| figure.anchors[*end].at).collect();
        let now: Vec<Vector> = ends.iter().map(|end| self.anchors[*end]).collect();
        inks(figure.parts[part].kind, &figure.sight, &rest, (&now, &self.curves[part]))
    }
}

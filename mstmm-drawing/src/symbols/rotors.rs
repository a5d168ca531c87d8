//! Shafts and discs that spin.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, direction, plus, turned};

/// Least and largest radius of a shaft, and of a disc, on the paper.
const OF_SHAFT: [f64; 2] = [2.0, 14.0];
const OF_DISC: [f64; 2] = [16.0, 70.0];

/// Half of the thickness of a disc.
const HALF_THICKNESS: f64 = 4.5;

/// A shaft around its axis, which may be bent.
pub(super) fn shaft(radius: f64, axis: Vec<Vector>) -> Vec<Ink> {
    let radius = radius.clamp(OF_SHAFT[0], OF_SHAFT[1]);
    let side = |place: usize, radius: f64| {
        let (before, behind) = (axis[place.saturating_sub(1)], axis[(place + 1).min(axis.len() - 1)]);
        let along = direction(plus(behind, before, -1.0)).unwrap_or([1.0, 0.0]);
        plus(axis[place], turned(along), radius)
    };
    let above = (0..axis.len()).map(|place| side(place, radius));
    let below = (0..axis.len()).rev().map(|place| side(place, -radius));
    let outline = above.chain(below).collect();
    vec![Ink::new(Pen::Area, Outline::Area(outline)), Ink::new(Pen::Hatch, Outline::line(axis))]
}

/// A disc, seen along its edge.
pub(super) fn disc(radius: f64, [x, y]: Vector) -> Vec<Ink> {
    let radius = radius.clamp(OF_DISC[0], OF_DISC[1]);
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[a, b]| [x + a * HALF_THICKNESS, y + b * radius]);
    vec![Ink::new(Pen::Area, Outline::Area(corners.into()))]
}

//! Shafts and discs that spin.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, direction, plus, turned};

/// Least and largest radius of shafts, and of a disc, on the paper.
const OF_SHAFTS: [f64; 2] = [2.5, 14.0];
const OF_DISC: [f64; 2] = [16.0, 70.0];

/// The factor of all radii of shafts by which the thinnest is seen and the thickest is no thicker than it may be.
pub(crate) fn factor(radii: impl Iterator<Item = f64> + Clone) -> f64 {
    let (least, most) = (radii.clone().fold(f64::INFINITY, f64::min), radii.fold(0.0, f64::max));
    if most > 0.0 { (OF_SHAFTS[0] / least).max(1.0).min(OF_SHAFTS[1] / most) } else { 1.0 }
}

/// The radius of a disc on the paper.
pub(crate) fn radius_of_disc(radius: f64) -> f64 {
    radius.clamp(OF_DISC[0], OF_DISC[1])
}

/// Half of the thickness of a disc.
const HALF_THICKNESS: f64 = 4.5;

/// A shaft around its axis, which may be bent.
pub(super) fn shaft(radius: f64, axis: Vec<Vector>) -> Vec<Ink> {
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

/// A disc, seen along its edge, given its centre and a point of its rim.
pub(super) fn disc(centre: Vector, rim: Vector) -> Vec<Ink> {
    let up = plus(rim, centre, -1.0);
    let along = turned(direction(up).unwrap_or([0.0, -1.0]));
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let corners = corners.map(|[a, b]| plus(plus(centre, along, a * HALF_THICKNESS), up, b));
    vec![Ink::new(Pen::Area, Outline::Area(corners.into()))]
}

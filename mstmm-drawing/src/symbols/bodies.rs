//! Rigid bodies and masses.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, direction, plus, turned};

/// Half of the width of a body around one point, within its edge, and half of the side of a block.
pub(crate) const BORDER: f64 = 9.0;
pub(crate) const HALF: f64 = 11.0;

/// A rigid body around the points that it ties, with its mass centre, the last of its ends.
pub(super) fn body(rest: &[Vector], ends: &[Vector]) -> Vec<Ink> {
    let hull: Vec<Vector> = hull(rest).into_iter().map(|end| ends[end]).collect();
    let [x, y] = ends[ends.len() - 1];
    let cross = vec![vec![[x - 4.5, y], [x + 4.5, y]], vec![[x, y - 4.5], [x, y + 4.5]]];
    vec![
        Ink::new(Pen::RigidEdge, Outline::Area(hull.clone())),
        Ink::new(Pen::Rigid, Outline::Area(hull)),
        Ink::new(Pen::Hollow, Outline::Disc([x, y], 4.5)),
        Ink::new(Pen::Hatch, Outline::Lines(cross)),
    ]
}

/// The corners of the convex hull of points, by their indices; of points in a line both ends.
pub(crate) fn hull(points: &[Vector]) -> Vec<usize> {
    let mut sorted: Vec<usize> = (0..points.len()).collect();
    sorted.sort_by(|a, b| points[*a][0].total_cmp(&points[*b][0]).then(points[*a][1].total_cmp(&points[*b][1])));
    let turns_left = |a: usize, b: usize, c: usize| {
        let [to_b, to_c] = [b, c].map(|other| plus(points[other], points[a], -1.0));
        to_b[0] * to_c[1] - to_b[1] * to_c[0] > 0.0
    };
    let half = |points: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for point in points {
            while chain.len() > 1 && !turns_left(chain[chain.len() - 2], chain[chain.len() - 1], point) {
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut sorted.iter().copied());
    hull.extend(half(&mut sorted.iter().rev().copied()));
    hull
}

/// A mass of a path.
pub(super) fn block([x, y]: Vector) -> Ink {
    let corners = [[-HALF, -HALF], [HALF, -HALF], [HALF, HALF], [-HALF, HALF]].map(|[a, b]| [x + a, y + b]);
    Ink::new(Pen::Area, Outline::Area(corners.into()))
}

/// A moment of inertia of a rotation path.
pub(super) fn disc(at: Vector) -> Vec<Ink> {
    let [x, y] = at;
    let cross = vec![vec![[x - 11.0, y], [x + 11.0, y]], vec![[x, y - 11.0], [x, y + 11.0]]];
    vec![Ink::new(Pen::Area, Outline::Disc(at, 11.0)), Ink::new(Pen::Hatch, Outline::Lines(cross))]
}

/// An element of the user's own: its line, and a box in the middle.
pub(super) fn other(from: Vector, to: Vector, curve: &[Vector]) -> Vec<Ink> {
    let line = if curve.is_empty() { vec![from, to] } else { curve.to_vec() };
    let middle = plus([0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])], [0.0; 2], 1.0);
    let along = direction(plus(to, from, -1.0)).unwrap_or([1.0, 0.0]);
    let across = turned(along);
    let corners = [(-12.0, -7.0), (12.0, -7.0), (12.0, 7.0), (-12.0, 7.0)];
    let corners = corners.map(|(a, b)| plus(plus(middle, along, a), across, b));
    let mut inks = vec![Ink::new(Pen::Thin, Outline::line(line))];
    if curve.is_empty() {
        inks.push(Ink::new(Pen::Area, Outline::Area(corners.into())));
    }
    inks
}

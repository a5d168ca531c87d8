//! Rigid bodies and masses.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, direction, plus, turned};

/// A rigid body around the points that it ties, with its mass centre, the last of its ends.
pub(super) fn body(ends: &[Vector]) -> Vec<Ink> {
    let hull = hull(ends);
    let [x, y] = ends[ends.len() - 1];
    let cross = vec![vec![[x - 4.5, y], [x + 4.5, y]], vec![[x, y - 4.5], [x, y + 4.5]]];
    vec![
        Ink::new(Pen::RigidEdge, Outline::Area(hull.clone())),
        Ink::new(Pen::Rigid, Outline::Area(hull)),
        Ink::new(Pen::Hollow, Outline::Disc([x, y], 4.5)),
        Ink::new(Pen::Hatch, Outline::Lines(cross)),
    ]
}

/// The convex hull of points; of two the line between them.
fn hull(points: &[Vector]) -> Vec<Vector> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let turns_left =
        |a: Vector, b: Vector, c: Vector| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0;
    let half = |points: &mut dyn Iterator<Item = Vector>| {
        let mut chain: Vec<Vector> = Vec::new();
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
    if hull.is_empty() { sorted } else { hull }
}

/// A mass of a path.
pub(super) fn block([x, y]: Vector) -> Ink {
    let half = 11.0;
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]].map(|[a, b]| [x + a, y + b]);
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

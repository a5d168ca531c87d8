//! Blocks and pyramids in space, of which the faces towards the reader are drawn.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, plus};
use crate::vector3::{Vector3, cross, dot3, length3, plus3};
use crate::view::Sight;

/// Part of the size of a face that one sees of it at least.
const SEEN: f64 = 1e-6;

/// A convex body by its faces.
pub(crate) struct Convex {
    faces: Vec<Vec<Vector3>>,
    /// A place inside.
    inside: Vector3,
}

impl Convex {
    /// A block around a place, with its axes and half of its sides.
    pub(crate) fn block(middle: Vector3, axes: [Vector3; 3], half: Vector3) -> Self {
        let corner = |signs: [f64; 3]| (0..3).fold(middle, |at, k| plus3(at, axes[k], signs[k] * half[k]));
        let face = |axis: usize, sign: f64| {
            let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[one, other]| {
                let mut signs = [sign; 3];
                (signs[(axis + 1) % 3], signs[(axis + 2) % 3]) = (one, other);
                corner(signs)
            });
            corners.into()
        };
        let faces = (0..3).flat_map(|axis| [face(axis, -1.0), face(axis, 1.0)]).collect();
        Convex { faces, inside: middle }
    }

    /// A pyramid whose tip is the origin, with a square base in a direction of length 1.
    pub(crate) fn pyramid(to_base: Vector3, [one, other]: [Vector3; 2], [height, half]: [f64; 2]) -> Self {
        let middle = plus3([0.0; 3], to_base, height);
        let base = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[a, b]| plus3(plus3(middle, one, a * half), other, b * half));
        let mut faces: Vec<Vec<Vector3>> = (0..4).map(|k| vec![[0.0; 3], base[k], base[(k + 1) % 4]]).collect();
        faces.push(base.into());
        Convex { faces, inside: plus3([0.0; 3], to_base, 0.75 * height) }
    }

    /// What is seen of it, with its origin at a place of the paper.
    pub(crate) fn inks(&self, sight: &Sight, at: Vector, pen: Pen) -> Vec<Ink> {
        let is_seen = |face: &&Vec<Vector3>| {
            let [first, second, third] = [face[0], face[1], face[2]];
            let normal = cross(plus3(second, first, -1.0), plus3(third, first, -1.0));
            let outwards = dot3(normal, plus3(first, self.inside, -1.0)).signum();
            outwards * sight.depth(normal) > SEEN * length3(normal)
        };
        let place = |corner: &Vector3| plus(at, sight.way(*corner), 1.0);
        let areas = self.faces.iter().filter(is_seen).map(|face| Outline::Area(face.iter().map(place).collect()));
        areas.map(|area| Ink::new(pen, area)).collect()
    }
}

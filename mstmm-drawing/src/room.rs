//! What is drawn where, as labels see it: boxes that are free, and boxes that are not.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, distance, dot, plus};
use std::collections::HashMap;

/// Side of the cells in which lines are looked up.
const CELL: f64 = 32.0;

/// A box by its middle and half of its sides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    pub(crate) middle: Vector,
    pub(crate) half: Vector,
}

/// A line with half of its thickness.
pub(crate) type Stroke = ([Vector; 2], f64);

impl Area {
    pub(crate) fn covers(&self, other: &Area) -> bool {
        (0..2).all(|axis| (self.middle[axis] - other.middle[axis]).abs() < self.half[axis] + other.half[axis])
    }

    /// Its corners.
    pub(crate) fn corners(&self) -> [Vector; 4] {
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|signs: Vector| [0, 1].map(|axis| self.middle[axis] + signs[axis] * self.half[axis]))
    }

    /// The place in it that is next to a place.
    pub(crate) fn nearest(&self, place: Vector) -> Vector {
        [0, 1].map(|axis| place[axis].clamp(self.middle[axis] - self.half[axis], self.middle[axis] + self.half[axis]))
    }

    /// Its distance from a line.
    pub(crate) fn distance(&self, line: [Vector; 2]) -> f64 {
        if self.is_crossed(line, 0.0) {
            return 0.0;
        }
        // both are convex: an end of the line, or a corner, is nearest
        let of_ends = line.map(|end| distance(end, self.nearest(end)));
        let of_corners = self.corners().map(|corner| from_line(corner, line));
        of_ends.into_iter().chain(of_corners).fold(f64::INFINITY, f64::min)
    }

    /// Whether a line of some thickness crosses it.
    pub(crate) fn is_crossed(&self, [from, to]: [Vector; 2], thickness: f64) -> bool {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let half = self.half[axis] + thickness;
            let (start, way) = (from[axis] - self.middle[axis], to[axis] - from[axis]);
            if way.abs() < 1e-9 {
                if start.abs() > half {
                    return false;
                }
                continue;
            }
            let [one, other] = [(-half - start) / way, (half - start) / way];
            (enter, leave) = (enter.max(one.min(other)), leave.min(one.max(other)));
        }
        enter <= leave
    }
}

/// The distance of a place from a line.
fn from_line(place: Vector, [from, to]: [Vector; 2]) -> f64 {
    let (way, arm) = (plus(to, from, -1.0), plus(place, from, -1.0));
    let square = dot(way, way);
    let part = if square > 0.0 { (dot(arm, way) / square).clamp(0.0, 1.0) } else { 0.0 };
    distance(place, plus(from, way, part))
}

/// An area with round corners: what is within its corners, or not farther from its sides than its border is wide.
#[derive(Clone, Debug)]
pub(crate) struct Shell {
    pub(crate) corners: Vec<Vector>,
    pub(crate) border: f64,
}

impl Shell {
    /// Whether a place is in it.
    fn holds(&self, place: Vector) -> bool {
        contains(&self.corners, place) || sides(&self.corners).any(|side| from_line(place, side) <= self.border)
    }

    /// Whether a box is in it: of a convex one all corners are.
    pub(crate) fn holds_all(&self, area: &Area) -> bool {
        area.corners().into_iter().all(|corner| self.holds(corner))
    }

    /// Whether a line is one of its sides.
    fn has_side(&self, [from, to]: [Vector; 2]) -> bool {
        self.corners.contains(&from) && self.corners.contains(&to)
    }
}

/// The sides of an area.
fn sides(corners: &[Vector]) -> impl Iterator<Item = [Vector; 2]> {
    (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]])
}

/// Whether a place is within corners: a ray from there crosses an odd number of sides.
fn contains(corners: &[Vector], [x, y]: Vector) -> bool {
    let crosses = |[[from_x, from_y], [to_x, to_y]]: [Vector; 2]| {
        (from_y > y) != (to_y > y) && x < from_x + (y - from_y) / (to_y - from_y) * (to_x - from_x)
    };
    sides(corners).filter(|side| crosses(*side)).count() % 2 == 1
}

/// All that is drawn, by places.
pub(crate) struct Room {
    strokes: Vec<Stroke>,
    cells: HashMap<[i64; 2], Vec<usize>>,
    /// Areas that hide what is below them.
    filled: Vec<Vec<Vector>>,
}

impl Room {
    pub(crate) fn of(inks: &[Ink]) -> Self {
        let is_filled = |ink: &&Ink| matches!(ink.pen, Pen::Rigid | Pen::Area | Pen::Base);
        let mut room = Room {
            strokes: Vec::new(),
            cells: HashMap::new(),
            filled: inks.iter().filter(is_filled).map(|ink| ink.outline.points()).collect(),
        };
        inks.iter().flat_map(strokes).for_each(|stroke| room.add(stroke));
        room
    }

    /// Adds a line.
    pub(crate) fn add(&mut self, stroke: Stroke) {
        let ([from, to], thickness) = stroke;
        let index = self.strokes.len();
        self.strokes.push(stroke);
        let half = [0, 1].map(|axis| 0.5 * (to[axis] - from[axis]).abs() + thickness);
        let around = Area { middle: [0, 1].map(|axis| 0.5 * (from[axis] + to[axis])), half };
        for cell in cells(&around) {
            // long oblique lines are not in all cells of their box
            let middle = cell.map(|place| (place as f64 + 0.5) * CELL);
            if (Area { middle, half: [0.5 * CELL; 2] }).is_crossed([from, to], thickness + 1e-6) {
                self.cells.entry(cell).or_default().push(index);
            }
        }
    }

    /// Whether nothing is drawn in a box.
    pub(crate) fn is_free(&self, area: &Area) -> bool {
        !self.is_crossed(area, 0) && !self.filled.iter().any(|corners| contains(corners, area.middle))
    }

    /// Whether nothing is drawn in a box within a shell above it; what was drawn before is hidden.
    pub(crate) fn is_free_in(&self, area: &Area, shell: &Shell) -> bool {
        let above = self.strokes.iter().rposition(|(line, _)| shell.has_side(*line)).map_or(0, |last| last + 1);
        shell.holds_all(area) && !self.is_crossed(area, above)
    }

    /// Whether a line crosses a box, of those drawn from an index on.
    fn is_crossed(&self, area: &Area, from: usize) -> bool {
        cells(area).filter_map(|cell| self.cells.get(&cell)).flatten().any(|index| {
            let (line, thickness) = self.strokes[*index];
            *index >= from && area.is_crossed(line, thickness)
        })
    }
}

/// The cells that a box touches.
fn cells(area: &Area) -> impl Iterator<Item = [i64; 2]> + use<> {
    let end = |axis: usize, sign: f64| ((area.middle[axis] + sign * area.half[axis]) / CELL).floor() as i64;
    let [columns, rows] = [0, 1].map(|axis| end(axis, -1.0)..=end(axis, 1.0));
    rows.flat_map(move |row| columns.clone().map(move |column| [column, row]))
}

/// The lines of an outline.
pub(crate) fn strokes(ink: &Ink) -> Vec<Stroke> {
    let thickness = match (ink.pen, ink.width) {
        (Pen::RigidEdge | Pen::Rigid, _) => 11.0,
        (_, Some(width)) => 0.5 * width + 0.7,
        (Pen::Beam, None) => 2.5,
        _ => 1.5,
    };
    let closed = |mut points: Vec<Vector>| {
        points.extend(points.first().copied());
        points
    };
    let chains: Vec<Vec<Vector>> = match &ink.outline {
        Outline::Lines(lines) => lines.clone(),
        Outline::Area(points) => vec![closed(points.clone())],
        disc @ Outline::Disc(..) => vec![closed(disc.points())],
    };
    let lines = chains.iter().flat_map(|chain| chain.windows(2));
    lines.map(|pair| ([pair[0], pair[1]], thickness)).collect()
}

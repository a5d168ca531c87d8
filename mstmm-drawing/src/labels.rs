//! Places for labels, where they cover neither each other nor, as far as there is room, what is drawn.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, plus};

/// Size of letters, and the width of one as a part of it: a bound for the fonts of the style sheet.
pub(crate) const SIZE: f64 = 13.0;
const WIDTH: f64 = 0.62;

/// Distance of a label from its place.
const GAP: f64 = 5.0;

/// Directions that are tried, and how much farther each round is.
const DIRECTIONS: u32 = 16;
const FARTHER: f64 = 6.0;
const ROUNDS: u32 = 40;

/// What a label on a line costs, and one on its way to it, beside a round.
const ON_INK: f64 = 8.0;

/// A label that is to be placed.
#[derive(Clone, Debug)]
pub(crate) struct Wanted {
    pub(crate) text: String,
    /// The class in the style sheet.
    pub(crate) class: &'static str,
    /// What the source calls the whole.
    pub(crate) title: String,
    pub(crate) at: Vector,
}

/// A label with the middle of its box.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    pub(crate) wanted: Wanted,
    pub(crate) middle: Vector,
}

/// A box by its middle and half of its sides.
#[derive(Clone, Copy)]
struct Area {
    middle: Vector,
    half: Vector,
}

impl Area {
    fn covers(&self, other: &Area) -> bool {
        (0..2).all(|axis| (self.middle[axis] - other.middle[axis]).abs() < self.half[axis] + other.half[axis])
    }

    /// Whether a line of some thickness crosses it.
    fn is_crossed(&self, [from, to]: [Vector; 2], thickness: f64) -> bool {
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

/// Half of the box of a text.
fn half_of(text: &str) -> Vector {
    [0.5 * WIDTH * SIZE * text.chars().count() as f64 + 1.0, 0.5 * SIZE]
}

/// The box of a placed label: its corners.
pub(crate) fn corners(label: &Placed) -> [Vector; 2] {
    let half = half_of(&label.wanted.text);
    [plus(label.middle, half, -1.0), plus(label.middle, half, 1.0)]
}

/// Whether nothing is drawn or written in a box, by its middle and half of its sides.
pub(crate) fn is_free(middle: Vector, half: Vector, inks: &[Ink], labels: &[Placed]) -> bool {
    let area = Area { middle, half };
    let mut texts = labels.iter().map(|label| Area { middle: label.middle, half: half_of(&label.wanted.text) });
    let mut drawn = inks.iter().flat_map(lines);
    !texts.any(|text| text.covers(&area)) && !drawn.any(|(line, thickness)| area.is_crossed(line, thickness))
}

/// Places labels one after the other.
pub(crate) fn placed(wanted: Vec<Wanted>, inks: &[Ink]) -> Vec<Placed> {
    let obstacles: Vec<([Vector; 2], f64)> = inks.iter().flat_map(lines).collect();
    let mut areas: Vec<Area> = Vec::new();
    let mut placed = Vec::new();
    for label in wanted {
        let half = half_of(&label.text);
        let mut best: Option<(f64, Area)> = None;
        for round in 0..ROUNDS {
            if best.is_some_and(|(cost, _)| f64::from(round) >= cost) {
                break;
            }
            for step in 0..DIRECTIONS {
                // upwards to the right first
                let angle = std::f64::consts::TAU * (f64::from(step) / f64::from(DIRECTIONS) + 0.125);
                let way = [angle.cos(), -angle.sin()];
                let reach = GAP + FARTHER * f64::from(round) + way[0].abs() * half[0] + way[1].abs() * half[1];
                let area = Area { middle: plus(label.at, way, reach), half };
                if areas.iter().any(|other| other.covers(&area)) {
                    continue;
                }
                let crossed = obstacles.iter().filter(|(line, thickness)| area.is_crossed(*line, *thickness)).count();
                let cost = f64::from(round) + ON_INK * crossed as f64 + 0.02 * f64::from(step);
                if best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, area));
                }
            }
        }
        // beyond all others there is room
        let below = areas.iter().map(|area| area.middle[1] + area.half[1]).fold(label.at[1], f64::max);
        let area = best.map_or(Area { middle: [label.at[0], below + half[1] + GAP], half }, |(_, area)| area);
        areas.push(area);
        placed.push(Placed { wanted: label, middle: area.middle });
    }
    placed
}

/// The lines of an outline, with half of their thickness.
fn lines(ink: &Ink) -> Vec<([Vector; 2], f64)> {
    let thickness = match ink.pen {
        Pen::RigidEdge | Pen::Rigid => 11.0,
        Pen::Beam => 2.5,
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
    chains
        .iter()
        .flat_map(|chain| chain.windows(2).map(|pair| ([pair[0], pair[1]], thickness)).collect::<Vec<_>>())
        .collect()
}

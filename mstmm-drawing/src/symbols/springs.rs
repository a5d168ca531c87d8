//! Springs and dampers.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::vector::{Vector, direction, distance, plus, turned};

/// Length of a spring or a damper between its leads, at most, and as a part of what there is.
const LONGEST: f64 = 44.0;
const PART: f64 = 0.66;

/// Half of the width of a spring, of a damper, and their distance where both stand side by side.
const SPRING: f64 = 7.0;
const DAMPER: f64 = 6.0;
const APART: f64 = 9.0;

/// The line between two ends, moved to its side: directions along and across, and where the symbol begins and ends.
struct Axis {
    along: Vector,
    across: Vector,
    ends: [Vector; 2],
    symbol: [Vector; 2],
}

impl Axis {
    fn new(from: Vector, to: Vector, aside: f64) -> Self {
        let along = direction(plus(to, from, -1.0)).unwrap_or([0.0, 1.0]);
        let across = turned(along);
        let length = distance(from, to);
        let half = 0.5 * LONGEST.min(PART * length);
        let middle = plus(plus(from, along, 0.5 * length), across, aside);
        let symbol = [plus(middle, along, -half), plus(middle, along, half)];
        Axis { along, across, ends: [from, to].map(|end| plus(end, across, aside)), symbol }
    }

    /// A place of the symbol: a part of its length, and a way across.
    fn at(&self, part: f64, across: f64) -> Vector {
        let [from, to] = self.symbol;
        plus(plus(from, plus(to, from, -1.0), part), self.across, across)
    }
}

/// A spring, moved to its side.
pub(super) fn spring(from: Vector, to: Vector, aside: f64) -> Vec<Ink> {
    let axis = Axis::new(from, to, aside);
    let mut line = vec![axis.ends[0], axis.symbol[0]];
    for tooth in 0..8 {
        let side = if tooth % 2 == 0 { SPRING } else { -SPRING };
        line.push(axis.at((0.5 + f64::from(tooth)) / 8.0, side));
    }
    line.extend([axis.symbol[1], axis.ends[1]]);
    vec![Ink::new(Pen::Spring, Outline::line(line))]
}

/// A dashpot, moved to its side: a cup at the first end, a piston at the other one.
pub(super) fn damper(from: Vector, to: Vector, aside: f64) -> Vec<Ink> {
    let axis = Axis::new(from, to, aside);
    let cup =
        [(0.78, DAMPER), (0.22, DAMPER), (0.22, -DAMPER), (0.78, -DAMPER)].map(|(part, across)| axis.at(part, across));
    let piston = [axis.at(0.52, 0.7 * DAMPER), axis.at(0.52, -0.7 * DAMPER)];
    let lines =
        vec![vec![axis.ends[0], axis.at(0.22, 0.0)], cup.into(), piston.into(), vec![axis.at(0.52, 0.0), axis.ends[1]]];
    vec![Ink::new(Pen::Spring, Outline::Lines(lines))]
}

/// A spring and a dashpot side by side.
pub(super) fn spring_damper(from: Vector, to: Vector) -> Vec<Ink> {
    let axis = Axis::new(from, to, 0.0);
    // both stand between two bars
    let inset = plus(axis.symbol[0], axis.ends[0], -1.0);
    let bars = [plus(axis.ends[0], inset, 0.7), plus(axis.ends[1], inset, -0.7)];
    let bar = |at: Vector| vec![plus(at, axis.across, APART), plus(at, axis.across, -APART)];
    let leads = vec![vec![axis.ends[0], bars[0]], bar(bars[0]), bar(bars[1]), vec![bars[1], axis.ends[1]]];
    let mut inks = vec![Ink::new(Pen::Spring, Outline::Lines(leads))];
    inks.extend(spring(bars[0], bars[1], APART));
    inks.extend(damper(bars[0], bars[1], -APART));
    inks
}

/// A torsion spring, a spiral on the line between both ends, or a torsion damper, a cup in the round.
pub(super) fn torsion(from: Vector, to: Vector, is_spring: bool) -> Vec<Ink> {
    let axis = Axis::new(from, to, 0.0);
    let middle = axis.at(0.5, 0.0);
    let point = |angle: f64, radius: f64| {
        plus(plus(middle, axis.along, -radius * angle.cos()), axis.across, radius * angle.sin())
    };
    let lines = if is_spring {
        let turns = 2.25 * std::f64::consts::TAU;
        let spiral = (0..=54).map(|k| f64::from(k) / 54.0).map(|part| point(part * turns, 2.0 + 9.0 * (1.0 - part)));
        vec![std::iter::once(axis.ends[0]).chain(spiral).collect(), vec![middle, axis.ends[1]]]
    } else {
        let arc = (0..=24).map(|k| 0.9 + f64::from(k) / 24.0 * 4.5).map(|angle| point(angle, 10.0));
        let vane = vec![point(0.0, 10.0), point(0.0, 4.0)];
        vec![
            vec![axis.ends[0], point(0.0, 10.0)],
            arc.collect(),
            vane,
            vec![point(std::f64::consts::PI, 10.0), axis.ends[1]],
        ]
    };
    vec![Ink::new(Pen::Spring, Outline::Lines(lines))]
}

/// Springs to the ground all along a beam.
pub(super) fn foundation(from: Vector, to: Vector) -> Vec<Ink> {
    let Some(along) = direction(plus(to, from, -1.0)) else { return Vec::new() };
    let across = turned(along);
    let length = distance(from, to);
    let count = (length / 22.0).floor().max(1.0) as u32;
    let at = |part: f64, way: f64| plus(plus(from, along, part * length), across, way);
    let mut springs = Vec::new();
    for k in 0..count {
        let part = (f64::from(k) + 0.5) / f64::from(count);
        let teeth = [(0.0, 3.0), (3.0, 6.0), (-3.0, 8.5), (3.0, 11.0), (-3.0, 13.5), (0.0, 16.0)];
        let teeth = teeth.map(|(aside, way)| plus(at(part, way), along, aside));
        springs.push(teeth.into());
    }
    let ground = vec![at(0.0, 16.0), at(1.0, 16.0)];
    vec![Ink::new(Pen::Hatch, Outline::Lines(springs)), Ink::new(Pen::Ground, Outline::line(ground))]
}

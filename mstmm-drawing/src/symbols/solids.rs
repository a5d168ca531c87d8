//! Joints and bodies in space.

use crate::ink::{Ink, Pen};
use crate::outline::Outline;
use crate::solid::Solid;
use crate::symbols::convex::Convex;
use crate::symbols::joints;
use crate::vector::{Vector, direction, plus, turned};
use crate::vector3::Vector3;
use crate::view::Sight;

/// Half of the length of the axis of a joint, and of a rail.
const AXIS: f64 = 11.0;
const RAIL: f64 = 9.0;

/// Least part of an axis that is seen of it where it leads to the reader.
const LEAST: f64 = 0.3;

/// Half of the side of the block of a body.
const BLOCK: f64 = 8.0;

/// What is drawn of a joint or a body, given its ends: as many lines and corners at any moment as at rest.
pub(super) fn inks(solid: Solid, sight: &Sight, ends: &[Vector]) -> Vec<Ink> {
    let at = ends[0];
    let disc = |radius: f64| Ink::new(Pen::Hollow, Outline::Disc(at, radius));
    match solid {
        Solid::Ball => vec![disc(4.5)],
        Solid::Revolute(axis) => [axes(sight, at, &[axis]), vec![disc(4.5)]].concat(),
        Solid::Universal(both) => [axes(sight, at, &both), vec![disc(4.5)]].concat(),
        Solid::Prismatic(axis) => rails(sight, at, axis, 4.5),
        Solid::Cylindrical(axis) => [vec![disc(4.5)], rails(sight, at, axis, 6.5)].concat(),
        Solid::Mount => joints::elastic(0.0, at, at),
        Solid::Joint => {
            let corners = [[-4.5, -4.5], [4.5, -4.5], [4.5, 4.5], [-4.5, 4.5]].map(|corner| plus(at, corner, 1.0));
            vec![Ink::new(Pen::Hollow, Outline::Area(corners.into()))]
        }
        Solid::Body => body(sight, ends),
    }
}

/// An axis on the paper; one that leads to the reader is short, and lies across.
fn on_paper(sight: &Sight, axis: Vector3) -> Vector {
    let [x, y] = sight.way(axis);
    match direction([x, y]) {
        Some(way) if x.hypot(y) < LEAST => way.map(|part| LEAST * part),
        Some(_) => [x, y],
        None => [LEAST, 0.0],
    }
}

/// Lines along axes through a joint.
fn axes(sight: &Sight, at: Vector, axes: &[Vector3]) -> Vec<Ink> {
    let line = |axis: &Vector3| [-AXIS, AXIS].map(|way| plus(at, on_paper(sight, *axis), way)).into();
    vec![Ink::new(Pen::Spring, Outline::Lines(axes.iter().map(line).collect()))]
}

/// Two rails along an axis.
fn rails(sight: &Sight, at: Vector, axis: Vector3, apart: f64) -> Vec<Ink> {
    let along = on_paper(sight, axis);
    let across = direction(along).map_or([0.0, 1.0], turned);
    let rail = |aside: f64| [-RAIL, RAIL].map(|way| plus(plus(at, across, aside), along, way)).into();
    vec![Ink::new(Pen::Spring, Outline::Lines(vec![rail(-apart), rail(apart)]))]
}

/// A block at the mass centre, and lines to all that the body ties.
fn body(sight: &Sight, ends: &[Vector]) -> Vec<Ink> {
    let Some((centre, tied)) = ends.split_last() else { return Vec::new() };
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let block = Convex::block([0.0; 3], axes, [BLOCK; 3]);
    let lines = tied.iter().map(|end| vec![*centre, *end]).collect();
    let mut inks = vec![Ink::new(Pen::Rod, Outline::Lines(lines))];
    inks.extend(block.inks(sight, *centre, Pen::Area));
    inks
}

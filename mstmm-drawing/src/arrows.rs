//! Arrows of loads on the paper.

use crate::diagram::written;
use crate::figure::Figure;
use crate::ink::{Ink, Pen};
use crate::labels::{Subject, Wanted};
use crate::loads::{Arrow, Loaded};
use crate::outline::Outline;
use crate::supports::directions_at;
use crate::triad::mark;
use crate::units::Units;
use crate::vector::{Vector, between, direction, distance, dot, plus, turned};
use crate::vector3::{Vector3, times};

/// The least length of the arrow of a force, and what the largest of all has besides.
const LEAST: f64 = 24.0;
const MORE: f64 = 24.0;

/// Distance of an arrow from its point; length and half of the width of its head.
const CLEAR: f64 = 4.0;
const HEAD: f64 = 9.0;
const HALF_HEAD: f64 = 3.6;

/// Radius of the arc of a moment, its points, and the part of a circle that it is.
const ARC: f64 = 16.0;
const POINTS: u32 = 24;
const TURN: f64 = 0.75 * std::f64::consts::TAU;

/// Length of the arrows of a load along a part, about how far they are apart, and how far those along it are beside it.
const SPREAD: f64 = 20.0;
const APART: f64 = 24.0;
const BESIDE: f64 = 12.0;

/// Part of its length below which an arrow is seen as a point, and the radius of the circle for it.
const SHORT: f64 = 0.15;
const CIRCLE: f64 = 5.5;

/// What is drawn of a load, and its amount.
pub(crate) struct Shown {
    pub(crate) inks: Vec<Ink>,
    pub(crate) label: Option<Wanted>,
}

/// What is drawn of loads. A load of amount zero is not drawn.
pub(crate) fn shown<M>(figure: &Figure<M>, loads: &[Loaded], units: &Units) -> Vec<Shown> {
    let is_force = |load: &&Loaded| matches!(load.arrows.first(), Some(Arrow::Force(..))) && !load.is_acceleration;
    let largest = loads.iter().filter(is_force).map(|load| load.amount.abs()).fold(0.0, f64::max);
    let acting = loads.iter().filter(|load| load.amount != 0.0);
    acting.map(|load| one(figure, load, largest, units)).collect()
}

fn one<M>(figure: &Figure<M>, load: &Loaded, largest: f64, units: &Units) -> Shown {
    let sign = load.amount.signum();
    let part = if load.is_acceleration { 0.0 } else { load.amount.abs() / largest };
    let mut inks = Vec::new();
    let mut subjects = Vec::new();
    for arrow in &load.arrows {
        let (drawn, subject) = match *arrow {
            Arrow::Force(anchor, way) => force(figure, anchor, times(way, sign), LEAST + MORE * part),
            Arrow::Moment(anchor, axis) => moment(figure, anchor, times(axis, sign)),
            Arrow::Spread(part, way) => spread(figure, part, times(way, sign)),
        };
        inks.extend(drawn);
        subjects.push(subject);
    }
    let unit = match load.arrows.first() {
        _ if load.is_acceleration => units.acceleration(),
        Some(Arrow::Moment(..)) => units.moment(),
        Some(Arrow::Spread(..)) => units.per_length(),
        _ => units.force.clone(),
    };
    let text = format!("{} {unit}", written(load.amount.abs()));
    let label = subjects.into_iter().next().map(|subject| {
        let title = format!("load of {} {unit}", written(load.amount));
        Wanted { text, class: "load", title, subject }
    });
    Shown { inks, label }
}

/// An arrow from one place to another, with heads at its end.
fn arrow([tail, tip]: [Vector; 2], heads: u32) -> Vec<Ink> {
    let Some(way) = direction(plus(tip, tail, -1.0)) else { return Vec::new() };
    let head = |back: f64| {
        let (end, foot) = (plus(tip, way, -back), plus(tip, way, -back - HEAD));
        let [left, right] = [HALF_HEAD, -HALF_HEAD].map(|aside| plus(foot, turned(way), aside));
        Ink::new(Pen::Dot, Outline::Area(vec![end, left, right]))
    };
    let line = Ink::new(Pen::Thin, Outline::line(vec![tail, plus(tip, way, -0.5 * HEAD)]));
    std::iter::once(line).chain((0..heads).map(|k| head(0.8 * HEAD * f64::from(k)))).collect()
}

/// An arrow along a way of space at a place: it ends there, or begins there where a part is in its way. One that leads to the reader is a circle.
fn pointed<M>(figure: &Figure<M>, at: Vector, way: Vector3, length: f64, heads: u32) -> (Vec<Ink>, Subject) {
    let seen = figure.sight.way(way);
    let Some(along) = direction(seen).filter(|_| seen[0].hypot(seen[1]) >= SHORT) else {
        let at = plus(at, [1.0, -1.0], 2.0 * CLEAR);
        let circle = Ink::new(Pen::Hollow, Outline::Disc(at, CIRCLE));
        return (
            vec![circle, Ink::new(Pen::Thin, mark(at, CIRCLE, figure.sight.depth(way) > 0.0))],
            Subject::Point(at),
        );
    };
    let parts = directions_at(figure, at);
    let is_taken = |way: Vector| parts.iter().any(|part| dot(*part, way) > 0.95);
    let [back, on] = [[-along[0], -along[1]], along];
    let length = length * seen[0].hypot(seen[1]).max(0.5);
    let [near, far] = [CLEAR, CLEAR + length];
    let ends = if is_taken(back) && !is_taken(on) {
        [plus(at, on, near), plus(at, on, far)]
    } else {
        [plus(at, back, far), plus(at, back, near)]
    };
    (arrow(ends, heads), Subject::Line(ends))
}

fn force<M>(figure: &Figure<M>, anchor: usize, way: Vector3, length: f64) -> (Vec<Ink>, Subject) {
    pointed(figure, figure.anchors[anchor].at, way, length, 1)
}

/// A moment: an arc around an axis that leads to the reader or away, else an arrow with two heads along it.
fn moment<M>(figure: &Figure<M>, anchor: usize, axis: Vector3) -> (Vec<Ink>, Subject) {
    let at = figure.anchors[anchor].at;
    let depth = figure.sight.depth(axis);
    if depth.abs() < 0.9 {
        return pointed(figure, at, axis, LEAST + MORE, 2);
    }
    // the paper has y downwards: anticlockwise is towards smaller angles
    let sense = -depth.signum();
    let angle = |part: f64| 0.75 * std::f64::consts::PI + sense * (part - 0.5) * TURN - 0.25 * std::f64::consts::PI;
    let place = |part: f64| plus(at, [angle(part).cos(), angle(part).sin()], ARC);
    let arc = (0..=POINTS).map(|k| place(f64::from(k) / f64::from(POINTS))).collect();
    let head = arrow([place(0.92), place(1.06)], 1).into_iter().skip(1);
    let inks = std::iter::once(Ink::new(Pen::Thin, Outline::line(arc))).chain(head).collect();
    (inks, Subject::Point(plus(at, [1.0, -1.0], ARC * 0.5_f64.sqrt())))
}

/// A row of arrows along a part: on the side from which they come, beside it where they lead along it.
fn spread<M>(figure: &Figure<M>, part: usize, way: Vector3) -> (Vec<Ink>, Subject) {
    let ends = &figure.parts[part].ends;
    let [from, to] = [ends[0], ends[1]].map(|end| figure.anchors[end].at);
    let (seen, along) = (figure.sight.way(way), direction(plus(to, from, -1.0)).unwrap_or([1.0, 0.0]));
    let Some(way) = direction(seen).filter(|_| seen[0].hypot(seen[1]) >= SHORT) else {
        return pointed(figure, between(from, to, 0.5), way, SPREAD, 1);
    };
    let count = (distance(from, to) / APART).floor().max(1.0) as u32;
    let across = turned(along);
    let is_along = dot(across, way).abs() < 0.3;
    let places: Vec<Vector> = if is_along {
        (0..count).map(|k| plus(between(from, to, (f64::from(k) + 0.5) / f64::from(count)), across, BESIDE)).collect()
    } else {
        (0..=count).map(|k| between(from, to, f64::from(k) / f64::from(count))).collect()
    };
    let reach = if is_along { [-0.5 * SPREAD, 0.5 * SPREAD] } else { [-CLEAR - SPREAD, -CLEAR] };
    let arrows = places.iter().map(|place| reach.map(|reach| plus(*place, way, reach)));
    let mut inks: Vec<Ink> = arrows.clone().flat_map(|ends| arrow(ends, 1)).collect();
    let [first, last] = [places[0], places[places.len() - 1]].map(|place| plus(place, way, reach[0]));
    if !is_along {
        inks.push(Ink::new(Pen::Thin, Outline::line(vec![first, last])));
    }
    (inks, Subject::Line([first, last]))
}
